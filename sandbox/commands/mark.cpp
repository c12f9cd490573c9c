#include "commands/commands.h"

#include "commands/answers.h"
#include "commands/progress_bar.h"
#include "commands/session.h"
#include "image/plain_text.h"
#include "image/write_files.h"
#include "teach/marking/answer_names.h"
#include "teach/marking/exercise_read.h"
#include "teach/marking/marks_page.h"
#include "teach/marking/sentences.h"
#include "teach/marking/student_file.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <iterator>
#include <utility>

namespace sandbox {
namespace {

constexpr OwnLimits limits_of_an_answer{.seconds_each = 4, .seconds_all = 6}; // right ones take less than 1

struct MarkFlags {
    std::string exercise;
    std::vector<std::filesystem::path> answers;
    std::filesystem::path out, json, csv, student;
    int hints = 2;
    std::string language{languages.front()};
};

Mark marked(Marker &marker, const AnswerFile &file) {
    try {
        const Answer answer = read_answer(file);
        const auto *text = std::get_if<OwnShader>(&answer);
        return text != nullptr ? marker.mark_own(*text) : marker.mark_picture(std::get<Observed>(answer));
    } catch (const InputError &error) {
        return marker.refuse(error.what());
    }
}

/// A link that lies where a page goes leads elsewhere: it goes, and what it leads to stays.
OutputFile inside(const std::filesystem::path &folder, const std::string &name, std::string bytes) {
    const std::filesystem::path path = folder / name;
    std::error_code ignored;
    if (std::filesystem::is_symlink(path, ignored)) {
        std::filesystem::remove(path, ignored);
    }
    return {path, std::move(bytes)};
}

/// EXERCISE.json as students get it, and EXERCISE.glsl to begin with.
int write_student_copy(const MarkFlags &flags, const Exercise &exercise, const CommonOptions &common) {
    const std::string json = exercise.name + ".json", glsl = exercise.name + ".glsl";
    make_folder("--student", flags.student, {json, glsl});
    write_files(std::vector<OutputFile>{
        inside(flags.student, json, student_copy(exercise)),
        inside(flags.student, glsl, student_file(exercise, ShaderParts(shader_assets(common))))});
    note(fmt::format("{0}/{1}.json and {0}/{1}.glsl written", plain_text(flags.student.string()), exercise.name));
    return 0;
}

void write_all(const Words &words, const MarkFlags &flags, const Exercise &exercise,
               const std::vector<MarkedAnswer> &marks) {
    const std::string json = marks_json(exercise, marks), csv = marks_csv(exercise, marks);
    std::vector<OutputFile> files;
    if (!flags.out.empty()) {
        files.push_back(inside(flags.out, "marks.json", json));
        files.push_back(inside(flags.out, "marks.csv", csv));
        files.push_back(inside(flags.out, "index.html", marks_index(words, exercise, marks)));
    }
    if (!flags.json.empty()) {
        files.push_back({flags.json, json});
    }
    if (!flags.csv.empty()) {
        files.push_back({flags.csv, csv});
    }
    write_files(files);
}

/// Before the work, not after it.
void check_outputs(const MarkFlags &flags) {
    if (!flags.out.empty()) {
        make_folder("--out", flags.out, {"marks.json", "marks.csv", "index.html"});
    }
    if (!flags.json.empty()) {
        with_flag("--json", [&] { check_writable(flags.json); });
    }
    if (!flags.csv.empty()) {
        with_flag("--csv", [&] { check_writable(flags.csv); });
    }
}

int run_mark(const MarkFlags &flags, const CommonOptions &common) {
    refuse_settings(common, "an exercise brings its own scenes");
    if (flags.hints < 0 || flags.hints > most_hints) {
        throw InputError("--hints: expected 0 to {}, got {}", most_hints, flags.hints);
    }
    const Assets assets = scene_assets(common);
    const Words words = words_in(flags.language, assets);
    const Exercise exercise = open_exercise(flags.exercise, assets, words);
    if (!flags.student.empty()) {
        if (!flags.answers.empty()) {
            throw InputError("mark: --student marks nothing: expected no ANSWER, got {}",
                             plain_text(flags.answers.front().string()));
        }
        return write_student_copy(flags, exercise, common);
    }
    if (flags.answers.empty()) {
        throw InputError("mark: expected an ANSWER, or --student");
    }
    const std::vector<AnswerFile> files = find_answers(flags.answers);
    std::vector<std::string> names;
    std::ranges::transform(files, std::back_inserter(names), &AnswerFile::name);
    const std::vector<std::string> pages = page_names(names);
    check_outputs(flags);

    DrawingSession session(common, DrawingSession::Own::drawn_apart, limits_of_an_answer);
    const MarkDraw draw = marks_drawn_by(session.renderer());
    Marker marker(exercise, draw);
    ProgressBar bar("mark " + exercise.name);
    std::vector<MarkedAnswer> marks;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const auto start = std::chrono::steady_clock::now();
        MarkedAnswer answer{files[i].name, pages[i], marked(marker, files[i]), {}};
        answer.said = sentences(words, exercise, answer.mark, flags.hints);
        if (!flags.out.empty()) {
            const OutputFile page = inside(flags.out, answer.page, mark_html(words, exercise, answer));
            write_file(page.path, page.bytes);
        }
        answer.mark.student = answer.mark.truth = {};
        marks.push_back(std::move(answer));
        if (common.verbose) {
            const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
            note(fmt::format("{}: {:.2f} s", plain_text(files[i].name), time.count()));
        }
        bar.report(static_cast<double>(i + 1) / static_cast<double>(files.size()));
    }
    print(marks_table(words, exercise, marks));
    write_all(words, flags, exercise, marks);
    return 0;
}

} // namespace

void add_mark_options(CLI::App &command, CommonOptions &common, Run &run) {
    const auto flags = std::make_shared<MarkFlags>();
    add_value(command, "EXERCISE", "", flags->exercise, "Built-in exercise (see: list), or path of a .json file")
        ->required();
    add_value(command, "ANSWER", "", flags->answers,
              "Own shaders (.glsl), pictures of the exercise's first scene (.png, .pfm), or folders of them, with all "
              "folders in those");
    add_value(command, "--hints", "N", flags->hints,
              "0: points alone; 1: and which term is wrong, where; 2: in which way; 3: by which fault [2]");
    add_language(command, flags->language, "Language of what is said [en]");
    add_value(command, "--out", "DIR", flags->out,
              "Write marks.json, marks.csv, index.html and a page an answer into this folder");
    add_value(command, "--json", "FILE", flags->json, "Write the marks as JSON");
    add_value(command, "--csv", "FILE", flags->csv, "Write the marks as CSV");
    add_value(command, "--student", "DIR", flags->student,
              "Mark nothing; write the student's copy, without what is withheld, and a file to begin with");
    command.footer(
        "Each term is judged apart, against the double-precision reference: ambient, diffuse and specular light in\n"
        "scenes where they shine alone, with attenuation 1, wide cones and untransformed objects where these are\n"
        "asked for, too; attenuation and cones by the ratio of pictures with them and without; normals by a term\n"
        "that is right without a transform; the sum by adding up the answer's own pictures; robustness by extreme\n"
        "scenes, in which every pixel must be finite. So one error costs once. A term gets its points times the\n"
        "share of its pictures (a scene and a light) that are within the tolerance. Edges, jumps and outlines are\n"
        "left out, as `compare` leaves them out. A picture is diagnosed; what is named costs its term.\n"
        "An answer that cannot be read, built or drawn gets no points; exit code 0 all the same.\n"
        "An exercise is a JSON file; assets/exercise.schema.json describes it to editors.");
    run_when_chosen(command, common, run, flags, run_mark);
}

} // namespace sandbox
