#include "image/write_files.h"
#include "scene/assets.h"
#include "teach/marking/exercise_read.h"
#include "tools/answer_class.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

/// write_class EXERCISE COUNT SEED FOLDER: a class of answers to try `mark` on.
int main(int argc, char **argv) {
    using namespace sandbox;
    if (argc != 5) {
        std::fputs("write_class EXERCISE COUNT SEED FOLDER\n", stderr);
        return 2;
    }
    const Assets assets("assets");
    const Exercise exercise = open_exercise(argv[1], assets, words_in("en", assets));
    std::vector<std::string> terms;
    for (const TermPoints &row : exercise.terms) {
        terms.emplace_back(term_words[static_cast<std::size_t>(row.term)]);
    }
    const std::filesystem::path folder(argv[4]);
    std::filesystem::create_directories(folder);
    const auto count = static_cast<std::size_t>(std::atoi(argv[2]));
    for (const ClassAnswer &answer :
         answer_class(exercise.target, terms, count, static_cast<unsigned>(std::atoi(argv[3])))) {
        write_file(folder / answer.name, answer.text);
    }
    return 0;
}
