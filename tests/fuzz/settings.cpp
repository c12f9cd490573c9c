#include "ui/session/settings.h"

#include "fuzz/target.h"
#include "fuzz/targets.h"

#include <optional>

namespace sandbox {
namespace {

/// A damaged file, whatever is wrong with it, is set aside.
std::optional<Settings> settings_of(std::string_view text) {
    try {
        return parse_settings(text, "settings.json");
    } catch (const std::exception &) {
        return std::nullopt;
    }
}

} // namespace

void check_settings(std::string_view bytes) {
    const auto settings = settings_of(bytes);
    if (!settings) {
        return;
    }
    const Size window = settings->window;
    held(settings->scale >= 0.6 && settings->scale <= 3, "the scale is within its range");
    held(window.width >= least_window.width && window.width <= 16384 && window.height >= least_window.height &&
             window.height <= 16384,
         "the window is within its range");
    held(settings->recent.size() <= most_recent, "there are not too many recent files");
    held(settings_of(settings_text(*settings)) == settings, "settings read back as they were");
}

std::vector<std::string> settings_seeds() {
    Settings used;
    used.dark = false;
    used.scale = 1.5;
    used.language = "zh";
    used.panel_sizes = {20, 0.5F};
    used.recent = {"/a/b.json", "/a/c.obj"};
    used.lessons.last = "light-types";
    used.lessons.step = 2;
    used.lessons.seen = {{"light-types", {0, 1, 2}}};
    used.exercises = {"ambient"};
    return {settings_text({}), settings_text(used)};
}

} // namespace sandbox
