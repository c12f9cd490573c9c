#include "capture/frame_names.h"

#include "capture/picture_ranges.h"
#include "capture/sidecar.h"
#include "capture/sidecar_json.h"
#include "image/error.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

struct ExpandedPattern {
    std::string name;
    int numbers = 0;
    bool valid = true; ///< no other conversion stands in it
};

/// `pattern` with `number` for every %d and %0Nd, and a percent sign for every %%.
ExpandedPattern expand(std::string_view pattern, int number) {
    ExpandedPattern out;
    while (!pattern.empty()) {
        const bool padded = pattern.size() >= 4 && pattern.starts_with("%0") && pattern[2] >= '1' &&
                            pattern[2] <= '9' && pattern[3] == 'd';
        std::size_t length = 1;
        if (padded || pattern.starts_with("%d")) {
            out.name += fmt::format("{:0{}}", number, padded ? pattern[2] - '0' : 1);
            ++out.numbers;
            length = padded ? 4 : 2;
        } else if (pattern.starts_with("%%")) {
            out.name += '%';
            length = 2;
        } else {
            out.name += pattern.front();
            out.valid = out.valid && pattern.front() != '%';
        }
        pattern.remove_prefix(length);
    }
    return out;
}

} // namespace

double orbit_degrees(double degrees, int i, int frames) { return degrees * i / frames; }

bool is_frame_pattern(std::string_view pattern) { return expand(pattern, 0).numbers > 0; }

std::string frame_name(std::string_view pattern, int i) {
    const ExpandedPattern expanded = expand(pattern, i);
    if (!expanded.valid || expanded.numbers != 1) {
        throw InputError(
            "expected a file name with exactly one frame number such as %04d (%% for a percent sign), got '{}'",
            pattern);
    }
    return expanded.name;
}

std::string turntable_text(std::string_view first_frame, const Turntable &turntable) {
    const nlohmann::ordered_json keys{{"frames", turntable.frames}, {"orbit_degrees", turntable.degrees}};
    return with_keys(first_frame, keys.dump());
}

std::optional<Turntable> turntable_of(std::string_view text, std::string_view name) {
    const auto json = sidecar_json(text, name);
    if (!json.contains("frames") && !json.contains("orbit_degrees")) {
        return std::nullopt;
    }
    const auto frames = json.find("frames"), degrees = json.find("orbit_degrees");
    if (frames == json.end() || degrees == json.end() || !frames->is_number_integer() || !degrees->is_number()) {
        throw InputError("{}: expected both frames, a whole number, and orbit_degrees, a number", name);
    }
    const char *key = "frames";
    try {
        const int count = checked_frames(static_cast<int>(std::clamp(frames->get<double>(), -1.0, 1e9)));
        key = "orbit_degrees";
        return Turntable{count, checked_number(degrees->get<double>(), rotation)};
    } catch (const InputError &error) {
        throw InputError("{}: {}: {}", name, key, error.what());
    }
}

std::string motion_sidecar(std::string_view sidecar, const Motion &motion) {
    nlohmann::ordered_json keys;
    keys["motion"] = nlohmann::ordered_json::parse(motion_text(motion));
    return with_keys(sidecar, keys.dump());
}

std::optional<Motion> motion_of(std::string_view text, std::string_view name) {
    const auto json = sidecar_json(text, name);
    if (!json.contains("motion")) {
        return std::nullopt;
    }
    return parse_motion(json.at("motion").dump(), name);
}

int checked_frames(int frames) {
    if (frames < 1 || frames > 100000) {
        throw InputError("expected 1 to 100000, got {}", frames);
    }
    return frames;
}

} // namespace sandbox
