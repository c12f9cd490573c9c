#include "tools/source_text.h"
#include "words/words.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

/// What the window says stands in assets/words, not in its code; and nothing stands there that nobody says.
namespace sandbox {
namespace {

/// The string literals of C++ text, without comments, #include lines and messages of errors, which stay English.
std::vector<std::string> literals_of(const std::string &text) {
    static const std::regex skipped(
        R"(//[^\n]*|#include[^\n]*|(InputError|MachineError)\((?:[^;"]|"(?:\\.|[^"\\])*")*;)");
    static const std::regex literal(R"re("((?:\\.|[^"\\])*)")re");
    const std::string code = std::regex_replace(text, skipped, "");
    std::vector<std::string> found;
    for (std::sregex_iterator at(code.begin(), code.end(), literal), end; at != end; ++at) {
        found.push_back((*at)[1]);
    }
    return found;
}

/// Words for a person begin with a capital or hold a space between letters.
bool reads_as_text(const std::string &literal) {
    static const std::regex text(R"([A-Z][a-z]+|[a-z]{2,} [a-z]{2,}|[a-z]{2,}: |[A-Z][a-z]+ .*)");
    return std::regex_search(literal, text);
}

/// What may stand in the code, and why.
const std::map<std::string, std::string> allowed = {
    {"Side panel", "Dear ImGui's name of a window without a title"},
    {"Tabs", "likewise"},
    {"Status", "scripts' name of the status line"},
    {"Keys", "scripts' name of the list of keys"},
    {"Truth", "scripts' name of the third view"},
    {"Truth/name", "likewise, of its caption"},
    {"Truth/state", "likewise"},
    {"View", "scripts' name of a single view"},
    {"View/differ", "scripts' name of a line of text"},
    {"View/description", "likewise"},
    {"View/divider", "likewise"},
    {"View/hint", "likewise"},
    {"View/pending", "likewise"},
    {"Difference", "scripts' name of the controls below a difference"},
    {"File", "scripts' name of the file dialog"},
    {"side edge", "scripts' name of a panel's edge"},
    {"bottom edge", "likewise"},
    {" tip", "scripts' name of a light's handle"},
    {"/look for", "scripts' name of a line of text"},
    {" - Shading Sandbox", "the program's name"},
    {"Shading Sandbox", "likewise"},
    {"Tab", "a key as its cap has it"},
    {"Shift+F", "likewise"},
    {"Shift+M", "likewise"},
    {"Ctrl+Shift+Z", "likewise"},
    {"Ctrl+C", "likewise"},
    {"Pictures", "a folder's name"},
    {"the sweep", "what a message of an error is about"},
    {"truth of B", "scripts' name of a column"},
    {"Page down", "a key as its cap has it"},
    {"Page up", "likewise"},
    {"Home", "likewise"},
    {"End", "likewise"},
};

bool is_allowed(const std::string &literal) {
    static const std::regex font(R"([\w-]+\.(ttf|ttc|otf))");
    static const std::regex key_cap(R"((Ctrl|Shift|Alt)[+ ].*|F\d+)");
    return allowed.contains(literal) || std::regex_match(literal, key_cap) || std::regex_match(literal, font);
}

/// Files whose texts are not the window's: scripts and the command line are English.
bool speaks_to_people(const std::string &file) {
    return !file.starts_with("script") && !file.starts_with("run_script") && !file.starts_with("glfw_window") &&
           !file.starts_with("session/open_file") && !file.starts_with("session/settings") &&
           !file.starts_with("session/written_files") && !file.starts_with("desktop") &&
           !file.starts_with("text_faults");
}

TEST(NoTextLeft, InTheCodeOfTheWindow) {
    for (const auto &[file, text] : source_files(SOURCE_DIR "/sandbox/ui", {".cpp", ".h"})) {
        for (const std::string &literal : speaks_to_people(file) ? literals_of(text) : std::vector<std::string>{}) {
            EXPECT_TRUE(!reads_as_text(literal) || is_allowed(literal)) << file << ": \"" << literal << '"';
        }
    }
}

TEST(NoTextLeft, InWhatTheRulesLetThrough) {
    EXPECT_EQ(literals_of("say(\"Press a key\"); // \"not this\"\nthrow InputError(\"nor this: {}\", x);\nf(\"a\");"),
              (std::vector<std::string>{"Press a key", "a"}));
    EXPECT_TRUE(reads_as_text("Run"));
    EXPECT_TRUE(reads_as_text("drag the line"));
    EXPECT_FALSE(reads_as_text("error_time.run"));
    EXPECT_FALSE(reads_as_text("##value"));
}

/// A key of the code is a text, and a text's key, or how it begins, stands in some code.
TEST(NoTextLeft, InTheTables) {
    std::set<std::string> literals{"message.no_font"}; // of an error
    for (const auto &[file, text] : source_files(SOURCE_DIR "/sandbox", {".cpp", ".h"})) {
        for (const std::string &literal : literals_of(text)) {
            literals.insert(literal);
        }
    }
    const auto used = [&](const std::string &key) {
        for (std::string begin = key; !begin.empty();) {
            if (literals.contains(begin) || literals.contains(begin + ".") || literals.contains(begin + ".{}")) {
                return true;
            }
            const auto dot = begin.rfind('.');
            begin.resize(dot == std::string::npos ? 0 : dot);
        }
        return false;
    };
    const Words english = words_in("en");
    for (const auto &[key, text] : english.all()) {
        const bool of_a_file = key.starts_with("lesson.") || key.starts_with("bug.") || key.starts_with("exercise.");
        EXPECT_TRUE(of_a_file || used(key)) << "nobody says " << key;
    }
}

} // namespace
} // namespace sandbox
