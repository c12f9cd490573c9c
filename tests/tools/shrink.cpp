#include "tools/shrink.h"

#include "image/error.h"
#include "scene/scene_file.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace sandbox {
namespace {

using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

std::optional<Scene> read(const Json &json) {
    try {
        return parse_scene(json.dump(), "shrunk", {});
    } catch (const InputError &) {
        return {}; // a key that is needed was dropped, a number left its range
    }
}

/// Everything inside, what holds much first.
std::vector<Pointer> places(const Json &json) {
    std::vector<Pointer> out;
    std::vector<Pointer> level{Pointer()};
    while (!level.empty()) {
        std::vector<Pointer> next;
        for (const Pointer &at : level) {
            for (const auto &[key, value] : json[at].items()) {
                next.push_back(json[at].is_array() ? at / std::stoul(key) : at / key);
            }
        }
        out.insert(out.end(), next.begin(), next.end());
        std::erase_if(next, [&](const Pointer &at) { return !json[at].is_structured(); });
        level = std::move(next);
    }
    return out;
}

Json without(Json json, const Pointer &at) {
    Json &parent = json[at.parent_pointer()];
    if (parent.is_array()) {
        parent.erase(std::stoul(at.back()));
    } else {
        parent.erase(at.back());
    }
    return json;
}

/// Simpler numbers than `value`, the simplest first.
std::vector<double> rounder(double value) {
    std::vector<double> out;
    for (const double simple : {0.0, 1.0, -1.0}) {
        if (value != simple) {
            out.push_back(simple);
        }
    }
    if (value != 0) {
        for (const int digits : {0, 1, 3}) {
            const double step = std::pow(10, std::floor(std::log10(std::abs(value))) - digits);
            out.push_back(std::stod(Json(std::round(value / step) * step).dump()));
        }
    }
    return out;
}

class Shrinker {
  public:
    Shrinker(Json json, const std::function<bool(const Scene &)> &fails) : json_(std::move(json)), fails_(fails) {}

    Json run() {
        while (drop() || round_numbers()) {
        }
        return json_;
    }

  private:
    /// Taken if it still fails. Every candidate is shorter as text, so there is an end.
    bool take(const Json &candidate) {
        if (candidate.dump().size() >= json_.dump().size()) {
            return false;
        }
        const auto scene = read(candidate);
        if (!scene || !fails_(*scene)) {
            return false;
        }
        json_ = candidate;
        return true;
    }

    bool drop() {
        bool any = false;
        for (bool again = true; again;) {
            again = false;
            const std::vector<Pointer> all = places(json_);
            for (auto at = all.rbegin(); at != all.rend(); ++at) { // later elements first: indices before them stay
                if (json_.contains(*at) && take(without(json_, *at))) {
                    any = again = true;
                }
            }
        }
        return any;
    }

    bool round_numbers() {
        bool any = false;
        for (const Pointer &at : places(json_)) {
            if (!json_[at].is_number()) {
                continue;
            }
            const auto value = json_[at].get<double>();
            for (const double simple : rounder(value)) {
                Json candidate = json_;
                candidate[at] = simple == std::floor(simple) && std::abs(simple) < 1e15
                                    ? Json(static_cast<long long>(simple))
                                    : Json(simple);
                if (take(candidate)) {
                    any = true;
                    break;
                }
            }
        }
        return any;
    }

    Json json_;
    const std::function<bool(const Scene &)> &fails_;
};

} // namespace

Scene shrunk(const Scene &scene, const std::function<bool(const Scene &)> &fails) {
    const auto smaller = read(Shrinker(Json::parse(scene_text(scene)), fails).run());
    return smaller && fails(*smaller) ? *smaller : scene;
}

} // namespace sandbox
