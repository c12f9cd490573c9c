#include "ui/script/script.h"

#include "image/error.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <charconv>
#include <sstream>

namespace sandbox {

namespace {

struct NamedKey {
    std::string_view name;
    int key;
};
constexpr NamedKey named_keys[] = {
    {"Space", GLFW_KEY_SPACE},      {"Tab", GLFW_KEY_TAB},        {"Enter", GLFW_KEY_ENTER},
    {"Escape", GLFW_KEY_ESCAPE},    {"Delete", GLFW_KEY_DELETE},  {"Backspace", GLFW_KEY_BACKSPACE},
    {"Left", GLFW_KEY_LEFT},        {"Right", GLFW_KEY_RIGHT},    {"Up", GLFW_KEY_UP},
    {"Down", GLFW_KEY_DOWN},        {"PageUp", GLFW_KEY_PAGE_UP}, {"PageDown", GLFW_KEY_PAGE_DOWN},
    {"Home", GLFW_KEY_HOME},        {"End", GLFW_KEY_END},        {"+", GLFW_KEY_EQUAL},
    {"-", GLFW_KEY_MINUS},          {"?", GLFW_KEY_SLASH},        {"Ctrl", GLFW_KEY_LEFT_CONTROL},
    {"Shift", GLFW_KEY_LEFT_SHIFT}, {"Alt", GLFW_KEY_LEFT_ALT},
};
constexpr NamedKey modifiers[] = {{"Ctrl+", GLFW_MOD_CONTROL}, {"Shift+", GLFW_MOD_SHIFT}, {"Alt+", GLFW_MOD_ALT}};

/// The words of a line; a # that begins a word begins a comment.
std::vector<std::string> words_of_line(std::string_view where, const std::string &line) {
    std::vector<std::string> words;
    for (std::size_t at = 0; (at = line.find_first_not_of(" \t\r", at)) != std::string::npos && line[at] != '#';) {
        const bool quoted = line[at] == '"';
        const std::size_t begin = quoted ? at + 1 : at;
        const std::size_t end = line.find_first_of(quoted ? "\"" : " \t\r", begin);
        if (quoted && end == std::string::npos) {
            throw InputError("{}: a quote without its end", where);
        }
        words.push_back(line.substr(begin, end - begin));
        at = end == std::string::npos ? line.size() : end + (quoted ? 1 : 0);
    }
    return words;
}

} // namespace

std::vector<ScriptLine> script_lines(std::string_view name, std::string_view text) {
    std::vector<ScriptLine> lines;
    std::istringstream in{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        std::vector<std::string> words = words_of_line(fmt::format("{}:{}", name, number), line);
        if (!words.empty()) {
            lines.push_back({number, std::move(words)});
        }
    }
    return lines;
}

KeyChord parse_key(std::string_view text) {
    KeyChord chord;
    std::string_view rest = text;
    for (bool again = true; again;) {
        const auto held = std::ranges::find_if(
            modifiers, [&](const NamedKey &m) { return rest.starts_with(m.name) && rest.size() > m.name.size(); });
        again = held != std::end(modifiers);
        if (again) {
            chord.mods |= held->key;
            rest.remove_prefix(held->name.size());
        }
    }
    if (const auto named = std::ranges::find(named_keys, rest, &NamedKey::name); named != std::end(named_keys)) {
        chord.key = named->key;
        return chord;
    }
    if (rest.size() == 1 && rest[0] > ' ' && rest[0] <= '~') { // GLFW names these as ASCII does, in capitals
        chord.key = rest[0] >= 'a' && rest[0] <= 'z' ? rest[0] - 'a' + 'A' : rest[0];
        return chord;
    }
    int number = 0;
    const auto [end, error] = std::from_chars(rest.data() + (rest.empty() ? 0 : 1), rest.data() + rest.size(), number);
    if (!rest.starts_with('F') || error != std::errc() || end != rest.data() + rest.size() || number < 1 ||
        number > 25) {
        throw InputError("expected a key such as F12, Ctrl+Z or PageDown, got '{}'", text);
    }
    chord.key = GLFW_KEY_F1 + number - 1;
    return chord;
}

} // namespace sandbox
