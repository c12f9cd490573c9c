#pragma once

#include "scene/mesh_factor.h"
#include "scene/scene_format.h"
#include "teach/lesson.h"

/// The lesson format, once: reading, checking and the JSON schema are made from these tables, as a scene's are from
/// scene_format.h's.
namespace sandbox {

template <>
inline constexpr std::array<std::string_view, 5> words_of<StepLayout>{"single", "side-by-side", "wipe", "difference",
                                                                      "three-up"};
template <> inline constexpr std::array<std::string_view, 2> words_of<Display>{"linear", "srgb"};

/// A switch of a step for what is drawn over the views.
constexpr auto overlay_field(const OverlayKind &kind) {
    return field(kind.word, static_cast<bool LessonStep::*>(kind.on), any, kind.help);
}

constexpr Range share{.low = 0, .high = 1};
constexpr Range above_zero{.low = 0, .above_low = true};
constexpr Range mesh_factor{.low = least_mesh_factor, .high = most_mesh_factor};

template <>
inline constexpr auto format_of<LookHere> =
    make_format("look", "A ring over every view of the picture.",
                field("at", &LookHere::at, share, "Shares of a view's width and height, from its upper left corner.",
                      {.needed = always<LookHere>}),
                field("radius", &LookHere::radius, share, "A share of a view's height."));

template <>
inline constexpr auto format_of<Question> =
    make_format("question", "A question whose answer is folded away.",
                field("asks", &Question::asks, any, "The question.", {.needed = always<Question>}),
                field("answer", &Question::answer, any, "Its answer.", {.needed = always<Question>}));

template <>
inline constexpr auto format_of<LessonClaim> = make_format(
    "claim", "What a step says, as a number that is measured: a metric and a bound, or words of a GLSL text.",
    field("says", &LessonClaim::says, any, "The claim in words; without them, the metric's."),
    field("metric", &LessonClaim::metric, any,
          "A metric of `compare`, or differing_bits, brightest, glsl_lines, run_time (milliseconds, never checked)."),
    field("of", &LessonClaim::of, any,
          "left, right, reference, analytic, twin, textbook or a technique; left without it."),
    field("against", &LessonClaim::against, any,
          "The same, or a colour [r, g, b]; reference (the other picture's model per pixel in double, every fault off) "
          "without it."),
    field("than", &LessonClaim::than, any, "The value is divided by the same figure of this picture."),
    field("set", &LessonClaim::set, any, "PATH=VALUE, as --set takes them: changes the step's scene for this claim."),
    field("against_set", &LessonClaim::against_set, any, "PATH=VALUE: changes the scene of `against` alone."),
    field("region", &LessonClaim::region, share, "left, top, right, bottom, as shares of the picture."),
    field("size", &LessonClaim::size, any, "WIDTHxHEIGHT of the pictures; 320x240 without it."),
    field("meshes", &LessonClaim::meshes, mesh_factor,
          "Two mesh factors or more, ascending: the value is the order at which the metric falls."),
    field("motion", &LessonClaim::motion_json, any,
          "A motion as sidecars have it: the value is the metric's largest from one moment to the next."),
    field("stage", &LessonClaim::stage, any, "The stage whose GLSL is read: vertex or fragment; both without it."),
    field("has", &LessonClaim::has, any, "Words that the GLSL of `of` holds, comments apart."),
    field("lacks", &LessonClaim::lacks, any, "Words that it does not hold."),
    field("below", &LessonClaim::below, any, "The value is below this."),
    field("above", &LessonClaim::above, any, "The value is above this."),
    field("equals", &LessonClaim::equals, any, "The value is exactly this."),
    field("about", &LessonClaim::about, above_zero, "The value is this, up to the factor `within`."),
    field("within", &LessonClaim::within, Range{.low = 1, .above_low = true}, "The factor around `about`."));

template <>
inline constexpr auto format_of<LessonStep> = make_format(
    "step", "A screenful: a text, a picture and the claims that back the text.",
    field("title", &LessonStep::title, any, "A few words.", {.needed = always<LessonStep>}),
    field("text", &LessonStep::text, any, "At most 60 words.", {.needed = always<LessonStep>}),
    field("scene", &LessonStep::scene_json, any,
          "A built-in scene's name, a path beside the lesson, or a scene; the last step's scene without it."),
    field("set", &LessonStep::set, any, "PATH=VALUE, as --set takes them: changes the scene."),
    field("camera", &LessonStep::camera_json, any, "The name of one of the scene's views, or a camera."),
    field("left", &LessonStep::left, any, "The technique of A; the last step's without it."),
    field("right", &LessonStep::right, any, "The technique of B; the last step's without it."),
    field("layout", &LessonStep::layout, any, "What the picture shows: A alone, A and B, their difference, ..."),
    field("mesh_factors", &LessonStep::mesh_factors, mesh_factor, "On the meshes of A and of B."),
    field("display", &LessonStep::display, any, "The transfer curve of the picture."),
    field("exposure", &LessonStep::exposure, above_zero, "A factor on the colours of the picture."),
    field("gain", &LessonStep::gain, above_zero, "A factor on a difference in the picture."),
    overlay_field(overlay_kinds[0]), overlay_field(overlay_kinds[1]), overlay_field(overlay_kinds[2]),
    overlay_field(overlay_kinds[3]), overlay_field(overlay_kinds[4]),
    field("look", &LessonStep::look, any, "Where to look."),
    field("tab", &LessonStep::tab, any,
          "The key of the window's tab to show beside the step: P probe, L profile, E error against run time, ..."),
    field("question", &LessonStep::question, any, "A question to think about."),
    field("asserts", &LessonStep::asserts, any, "false: the step claims nothing, and needs no claim."),
    field("claims", &LessonStep::claims, Range{.high = 100}, "What the text says, to be measured."));

template <>
inline constexpr auto format_of<Lesson> = make_format(
    "lesson",
    "A lesson of Shading Sandbox. A text is a string, {\"en\": ..., \"zh\": ...} or \"@key\" of "
    "assets/words.",
    field("title", &Lesson::title, any, "What the lesson is called.", {.needed = always<Lesson>}),
    field("about", &Lesson::about, any, "What it teaches, in one line."),
    field("order", &Lesson::order, any, "Lessons are listed in ascending order."),
    field("seen", &Lesson::seen, any, "Of a famous bug: what people saw."),
    field("cure", &Lesson::cure, any, "Of a famous bug: what helped."),
    field("source", &Lesson::source, any, "Of a famous bug: where it was told, a project and a number."),
    field("steps", &Lesson::steps, Range{.high = 1000}, "One after the other.", {.needed = always<Lesson>}));

} // namespace sandbox
