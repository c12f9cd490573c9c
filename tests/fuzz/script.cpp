#include "ui/script/script.h"

#include "capture/frame_names.h"
#include "capture/grid.h"
#include "fuzz/target.h"
#include "fuzz/targets.h"
#include "image/picture_size.h"
#include "image/plain_text.h"
#include "shading/technique.h"
#include "teach/marking/answer_names.h"

#include <algorithm>

namespace sandbox {
namespace {

void held_plain(std::string_view bytes) {
    const std::string line = plain_text(bytes), lines = plain_lines(bytes);
    held(is_utf8(line) && is_utf8(lines), "plain text is UTF-8");
    held(std::ranges::none_of(line, [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; }),
         "a plain line holds no control character");
    held(plain_text(line) == line && plain_lines(lines) == lines, "plain text is plain already");
}

void held_pages(const std::vector<std::string> &answers) {
    std::vector<std::string> pages = page_names(answers);
    held(pages.size() == answers.size(), "a page an answer");
    for (const std::string &page : pages) {
        held(page.ends_with(".html") && page.size() <= 255 &&
                 page.find_first_of("/\\:*?\"<>|\n") == std::string::npos && !page.starts_with('.'),
             "a page's name is safe: " + page);
    }
    std::ranges::sort(pages);
    held(std::ranges::adjacent_find(pages) == pages.end(), "no two pages are alike");
    for (const std::string &answer : answers) {
        const std::string cell = plain_cell(answer);
        held(cell.empty() || std::string_view("=+-@\t").find(cell.front()) == std::string_view::npos,
             "no cell is a formula");
    }
}

void check_word(const std::string &word) {
    accepted([&] { return parse_key(word); });
    accepted([&] { return frame_name(word, 7); });
    accepted([&] { return parse_sweep(word); });
    if (const auto size = accepted([&] { return parse_size(word); })) {
        check_size(*size);
    }
    if (const auto technique = accepted([&] { return parse_technique(word); })) {
        held(parse_technique(to_string(*technique)) == *technique, "a technique reads back as it was: " + word);
    }
}

} // namespace

/// A script for the window, and what its words, file names and the words of a command line become.
void check_script(std::string_view bytes) {
    held_plain(bytes);
    const auto lines = accepted([&] { return script_lines("a.txt", bytes); });
    if (!lines) {
        return;
    }
    for (const ScriptLine &line : *lines) {
        held(!line.words.empty() && line.number >= 1, "a line has a word and a number");
        held_pages(line.words);
        std::ranges::for_each(line.words, check_word);
    }
}

std::vector<std::string> script_seeds() {
    return {"# a comment\nkey Ctrl+Shift+Z\nclick \"two words\"\ndrag \"Light 1\" 10 20\n",
            "key F12 ? + Ctrl+PageUp\nwait 3\ncapture frame_%04d.png\n",
            "size 640x480 16384x4096\ntechnique per-pixel/blinn-phong:power=stable "
            "per-vertex/phong:gate=none,normals=model-matrix\n",
            "sweep lights[0].color=[1,0,0],[0,1,0]\nopen a.obj A.OBJ =1+2 con nul. \xE4\xBD\xA0\xE5\xA5\xBD\n"};
}

} // namespace sandbox
