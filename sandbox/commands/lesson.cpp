#include "commands/commands.h"

#include "capture/slide.h"
#include "commands/progress_bar.h"
#include "commands/session.h"
#include "image/png.h"
#include "image/write_files.h"
#include "teach/lesson_read.h"
#include "teach/lesson_report.h"
#include "ui/views/painters.h"

#include <fmt/format.h>

namespace sandbox {
namespace {

struct LessonFlags {
    std::string lesson;
    std::filesystem::path out;
    bool check = false;
    bool json = false;
    std::string language{languages.front()};
};

/// The page and the slides, together. An error names the step.
void write_lesson(const Words &words, const MeasuredLesson &measured, const std::filesystem::path &out,
                  DrawingSession &session) {
    const Lesson &lesson = measured.lesson;
    std::vector<ByteImage> slides;
    std::vector<OutputFile> files;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const LessonStep &step = lesson.steps[i];
        slides.push_back(with_flag(fmt::format("{}: steps[{}]", lesson.name, i), [&] {
            PictureOptions options = slide_options(step);
            options.language = words.language();
            return show_picture(step.scene, options, painters_of(session.renderer(), options.drawn_over));
        }));
        files.push_back({out / fmt::format("{}-{:02}.png", lesson.name, i + 1), encode_png(slides.back())});
    }
    files.push_back(
        {out / (lesson.name + ".html"), lesson_html(words, measured, slides, session.context().renderer())});
    write_files(files);
}

int run_lesson(const LessonFlags &flags, const CommonOptions &common) {
    refuse_settings(common, "a lesson brings its own scenes");
    const Assets assets = scene_assets(common);
    const Words words = words_in(flags.json ? languages.front() : flags.language, assets); // JSON stays English
    const bool all = flags.lesson == "all", gallery = flags.lesson == "gallery";
    const std::vector<Lesson> lessons = all       ? builtin_lessons(assets, words)
                                        : gallery ? builtin_bugs(assets, words)
                                                  : std::vector{open_lesson(flags.lesson, assets, words)};
    if (!flags.out.empty()) {
        make_folder("--out", flags.out, {all || gallery ? std::string("index.html") : lessons.front().name + ".html"});
    }
    DrawingSession session(common);
    const std::string renderer = session.context().renderer();
    ProgressBar bar("lesson " + flags.lesson);
    std::vector<MeasuredLesson> measured;
    bool passed = true;
    for (const Lesson &lesson : lessons) {
        LessonDraw draw = lessons_drawn_by(session.renderer());
        draw.words = words;
        measured.push_back({lesson, with_flag(lesson.name, [&] { return measure_lesson(lesson, draw); })});
        passed = passed && measured.back().result.passed();
        if (!flags.out.empty()) {
            write_lesson(words, measured.back(), flags.out, session);
        }
        if (!flags.json && (flags.check || flags.out.empty())) {
            print(lesson_table(measured.back()));
        }
        bar.report(static_cast<double>(measured.size()) / static_cast<double>(lessons.size()));
    }
    if (!flags.out.empty() && (all || gallery)) {
        write_file(flags.out / "index.html", all ? lessons_index(words, measured) : gallery_sheet(words, measured));
    }
    if (flags.json) {
        print(lessons_json(measured, renderer));
    }
    for (const auto &[lesson, result] : measured) {
        for (const std::string &claim : result.failed()) {
            note(fmt::format("{}: a claim does not hold: {}", lesson.name, claim));
        }
    }
    return passed ? 0 : 1;
}

} // namespace

void add_lesson_options(CLI::App &command, CommonOptions &common, Run &run) {
    const auto flags = std::make_shared<LessonFlags>();
    add_value(command, "NAME", "", flags->lesson,
              "Built-in lesson or bug (see: list), path of a .json file, all lessons (all), or all bugs (gallery)")
        ->required();
    command.add_flag("--check", flags->check, "Print every claim with what was measured (the default without --out)");
    add_language(command, flags->language, "Language of its texts [en]");
    command.add_flag("--json", flags->json, "Print JSON instead");
    add_value(command, "--out", "DIR", flags->out,
              "Write NAME.html and a picture a step, NAME-01.png, ..., into this folder; of all and gallery, "
              "index.html, too");
    command.footer(
        "Every claim is measured on the spot; exit code 1 if one does not hold. Run times are shown, never checked.\n"
        "A lesson is a JSON file (assets/lesson.schema.json describes it to editors), such as\n"
        "  {\"title\": \"Gates\", \"steps\": [\n"
        "    {\"title\": \"No test\", \"text\": \"Without a test, highlights shine from behind.\",\n"
        "     \"scene\": \"spot-light\", \"left\": \"per-pixel/phong:gate=none\", \"right\": \"per-pixel/phong\",\n"
        "     \"claims\": [{\"metric\": \"max_abs\", \"of\": \"left\", \"against\": \"right\", \"above\": 0.1}]}]}\n"
        "A step without a claim that is checked is refused, unless it says \"asserts\": false.");
    run_when_chosen(command, common, run, flags, run_lesson);
}

} // namespace sandbox
