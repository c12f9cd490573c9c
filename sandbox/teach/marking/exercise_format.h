#pragma once

#include "scene/scene_format.h"
#include "teach/marking/exercise.h"

/// The exercise format, once: reading, checking and the JSON schema are made from these tables, as a scene's are from
/// scene_format.h's.
namespace sandbox {

template <> inline constexpr auto words_of<MarkTerm> = term_words;

template <>
inline constexpr auto format_of<ExerciseScene> = make_format(
    "exercise_scene", "A scene that answers are drawn in.",
    field("name", &ExerciseScene::name, any, "What sentences call it; without it, its number."),
    field("scene", &ExerciseScene::scene_json, any,
          "A built-in scene's name, a path beside the exercise, or a scene; the first one's without it."),
    field("set", &ExerciseScene::set, any, "PATH=VALUE, as --set takes them: changes the scene."),
    field("withheld", &ExerciseScene::withheld, any, "true: marked, but not in the student's copy."),
    field("stiff", &ExerciseScene::stiff, any, "true: an extreme scene, in which every pixel must be finite."));

template <>
inline constexpr auto format_of<TermPoints> = make_format(
    "term", "What one term is worth: its points, times the share of its pictures that are within the tolerance.",
    field("term", &TermPoints::term, any, "ambient, diffuse, specular, attenuation, cone, normals, sum, robustness.",
          {.needed = always<TermPoints>}),
    field("points", &TermPoints::points, Range{.low = 0, .high = 1000, .above_low = true}, "Points where it is right."),
    field("tolerance", &TermPoints::tolerance, Range{.low = 0, .high = 1, .above_low = true},
          "The largest error of linear light that counts as right; 1/255, one level of 8 bits, without it."));

template <>
inline constexpr auto format_of<Exercise> = make_format(
    "exercise",
    "An exercise of Shading Sandbox. A text is a string, {\"en\": ..., \"zh\": ...} or \"@key\" of "
    "assets/words.",
    field("title", &Exercise::title, any, "What the exercise is called.", {.needed = always<Exercise>}),
    field("about", &Exercise::about, any, "What it trains, in one line."),
    field("task", &Exercise::task, any, "What is to be written.", {.needed = always<Exercise>}),
    field("order", &Exercise::order, any, "Exercises are listed in ascending order."),
    field("target", &Exercise::target, any,
          "The technique that answers are held against, without faults: per-pixel/phong, per-vertex/lambert, ..."),
    field("has", &Exercise::has, any,
          "Words that an answer's text must use, such as the name of a function; else it is not marked."),
    field("lacks", &Exercise::lacks, any, "Words that it must not use."),
    field("size", &Exercise::size, any, "WIDTHxHEIGHT of the pictures that are marked; 160x120 without it."),
    field("scenes", &Exercise::scenes, Range{.high = 32}, "Where it is marked; the first is shown.",
          {.needed = always<Exercise>}),
    field("terms", &Exercise::terms, any, "What is asked for.", {.needed = always<Exercise>}));

} // namespace sandbox
