#include "ui/session/settings.h"

#include "image/error.h"
#include "image/file_io.h"
#include "image/write_files.h"
#include "scene/read_json.h"
#include "words/words.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

namespace sandbox {

namespace fs = std::filesystem;

fs::path settings_file() {
    const auto folder = [](const char *name) {
        const char *value = std::getenv(name);
        return fs::path(value != nullptr ? value : "");
    };
    fs::path config = folder("XDG_CONFIG_HOME");
    if (!config.is_absolute()) { // the specification says: then ignore it
        const fs::path home = folder("HOME");
        config = home.is_absolute() ? home / ".config" : fs::path();
    }
    return config.empty() ? config : config / "shading-sandbox" / "settings.json";
}

namespace {

float panel_size(const nlohmann::json &from, const char *key, float least, float most) {
    const double size = from.value(key, 0.0);
    return size == 0 ? 0 : static_cast<float>(std::clamp<double>(size, least, most));
}

/// A step of a lesson. The library would make any number of -1 and of 1e300.
std::size_t step_from(const nlohmann::json &from) {
    constexpr double most = 9999; // more than any lesson has; each lesson shows its last one in place of those beyond
    return static_cast<std::size_t>(std::clamp(from.get<double>(), 0.0, most));
}

LessonProgress progress_from(const nlohmann::json &from) {
    LessonProgress progress;
    progress.last = from.value("last", "");
    progress.step = step_from(from.value("step", nlohmann::json(0)));
    const nlohmann::json all = from.value("seen", nlohmann::json::object());
    for (const auto &[lesson, steps] : all.items()) {
        std::set<std::size_t> &seen = progress.seen[lesson];
        std::ranges::transform(steps, std::inserter(seen, seen.end()), step_from);
    }
    return progress;
}

} // namespace

Settings parse_settings(std::string_view text, std::string_view name) {
    const nlohmann::json from = read_json<nlohmann::json>(text, name);
    Settings settings;
    settings.dark = from.value("dark", settings.dark);
    settings.panels = from.value("panels", settings.panels);
    settings.scale = std::clamp(from.value("scale", settings.scale), 0.6, 3.0);
    settings.recent = from.value("recent", settings.recent);
    settings.recent.resize(std::min(settings.recent.size(), most_recent));
    const std::string language = from.value("language", settings.language);
    settings.language = std::ranges::find(languages, language) != languages.end() ? language : "";
    settings.panel_sizes.side_ems = panel_size(from, "side_ems", least_side_ems, most_side_ems);
    settings.panel_sizes.bottom_share = panel_size(from, "bottom_share", least_bottom_share, most_bottom_share);
    if (const auto lessons = from.find("lessons"); lessons != from.end()) {
        settings.lessons = progress_from(*lessons);
    }
    settings.exercises = from.value("exercises", settings.exercises);
    const auto size = from.value("window", std::array<double, 2>{static_cast<double>(settings.window.width),
                                                                 static_cast<double>(settings.window.height)});
    settings.window = {static_cast<int>(std::clamp<double>(size[0], least_window.width, 16384)),
                       static_cast<int>(std::clamp<double>(size[1], least_window.height, 16384))};
    return settings;
}

Settings read_settings(const fs::path &file, std::string &message) {
    std::error_code error;
    if (file.empty() || !fs::exists(file, error)) {
        return {};
    }
    try {
        return parse_settings(read_file(file, largest_json), file.string());
    } catch (const std::exception &) { // no JSON, or other values
        const fs::path aside = file.string() + ".damaged";
        fs::rename(file, aside, error);
        message = fmt::format("The settings were damaged; they were {} {}.", error ? "left in" : "set aside as",
                              (error ? file : aside).string());
        return {};
    }
}

std::string settings_text(const Settings &settings) {
    const nlohmann::ordered_json to{
        {"dark", settings.dark},
        {"panels", settings.panels},
        {"scale", settings.scale},
        {"language", settings.language},
        {"window", {settings.window.width, settings.window.height}},
        {"side_ems", settings.panel_sizes.side_ems},
        {"bottom_share", settings.panel_sizes.bottom_share},
        {"recent", settings.recent},
        {"lessons",
         {{"last", settings.lessons.last}, {"step", settings.lessons.step}, {"seen", settings.lessons.seen}}},
        {"exercises", settings.exercises}};
    return to.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void write_settings(const fs::path &file, const Settings &settings) {
    std::error_code error;
    fs::create_directories(fs::absolute(file).parent_path(), error);
    if (error) {
        throw InputError("cannot make the folder {}: {}", file.parent_path().string(), error.message());
    }
    write_file(file, settings_text(settings));
}

std::string system_language() {
    for (const char *name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        if (const char *value = std::getenv(name); value != nullptr && *value != '\0') {
            const std::string_view word =
                std::string_view(value).substr(0, std::string_view(value).find_first_of("_.@"));
            const auto found = std::ranges::find(languages, word);
            return std::string(found != languages.end() ? *found : languages.front());
        }
    }
    return std::string(languages.front());
}

void add_recent(Settings &settings, const fs::path &path) {
    const std::string name = fs::absolute(path).string();
    std::erase(settings.recent, name);
    settings.recent.insert(settings.recent.begin(), name);
    settings.recent.resize(std::min(settings.recent.size(), most_recent));
}

} // namespace sandbox
