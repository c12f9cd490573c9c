#include "scene/motion.h"

#include "image/error.h"
#include "scene/light_kind.h"
#include "scene/orbit.h"
#include "scene/read_json.h"
#include "scene/scene_setting.h"
#include "scene/table_read.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

namespace sandbox {
namespace {

using nlohmann::ordered_json;

constexpr std::array<std::string_view, 4> mover_words{"camera", "light", "object", "number"};
constexpr std::array<std::string_view, 2> course_words{"turn", "to-and-fro"};

template <class E> E parse_word(std::string_view word, const auto &words) {
    const auto found = std::ranges::find(words, word);
    if (found == words.end()) {
        throw InputError("expected {}, got '{}'", fmt::join(words, ", "), word);
    }
    return static_cast<E>(found - words.begin());
}

template <class T> void collect(const T &value, const std::string &prefix, std::vector<SceneNumber> &out);

/// `at`: its path, without a dot behind it.
template <class M>
void collect_member(const M &member, const std::string &at, const Range &range, bool has_control,
                    std::vector<SceneNumber> &out) {
    if constexpr (HasFormat<M>) {
        collect(member, at + ".", out);
    } else if constexpr (std::is_same_v<M, double> || std::is_same_v<M, int>) {
        if (has_control) {
            out.push_back({at, static_cast<double>(member), std::is_same_v<M, int>, range});
        }
    } else if constexpr (std::is_same_v<M, glm::dvec2> || std::is_same_v<M, glm::dvec3>) {
        for (int i = 0; i < M::length() && has_control; ++i) {
            out.push_back({fmt::format("{}[{}]", at, i), member[i], false, range});
        }
    } else if constexpr (std::is_same_v<M, std::vector<Light>> || std::is_same_v<M, std::vector<Object>>) {
        for (std::size_t i = 0; i < member.size(); ++i) {
            collect(member[i], fmt::format("{}[{}].", at, i), out);
        }
    } else if constexpr (std::is_same_v<M, Shape>) {
        std::visit([&](const auto &shape) { collect(shape, at + ".", out); }, member);
    }
}

template <class T> void collect(const T &value, const std::string &prefix, std::vector<SceneNumber> &out) {
    for_each_field<T>([&](const auto &field) {
        if (field.rules.used(value)) {
            collect_member(value.*field.member, prefix + std::string(field.key), field.range, field.has_control, out);
        }
    });
}

/// Throws InputError if there is none.
SceneNumber number_at(const Scene &scene, const std::string &path) {
    for (SceneNumber &number : numbers_of(scene)) {
        if (number.path == path) {
            return std::move(number);
        }
    }
    throw InputError("motion: the scene has no number '{}'", path);
}

/// Each as the camera's position would turn about its target.
void orbit_light(Light &light, const Camera &camera, double degrees) {
    Camera stand = camera;
    stand.position = light.position;
    light.position = orbit_camera(stand, degrees).position;
    stand.position = light.direction;
    stand.target = {}; // added to a far target, a direction would lose its digits
    light.direction = orbit_camera(stand, degrees).position;
}

/// What moves must stay where a scene file can say it is.
void expect_within(const Range &range, const glm::dvec3 &position, const Motion &motion) {
    if (glm::any(glm::greaterThan(glm::abs(position), glm::dvec3(range.high)))) {
        throw InputError("motion: {}: expected coordinates within {:g}, got {:g}, {:g}, {:g}", motion_words(motion),
                         range.high, position.x, position.y, position.z);
    }
}

/// A number that is moved has a range of its own, which the scene checks.
void expect_degrees(const Motion &motion, double value) {
    const std::string broken = broken_rule(value, rotation, "a number");
    if (motion.mover != Mover::number && !broken.empty()) {
        throw InputError("expected {}, got {:g}", broken, value);
    }
}

template <class Things> auto &thing(Things &things, const Motion &motion, const char *name) {
    if (motion.index >= things.size()) {
        throw InputError("motion: {} {} is asked for; there are {}", name, motion.index + 1, things.size());
    }
    return things[motion.index];
}

} // namespace

int moments_of(const Motion &motion) {
    return std::max(2, static_cast<int>(std::lround(motion.seconds * moments_a_second)));
}

double value_at(const Motion &motion, int moment) {
    const int count = moments_of(motion);
    const double share = static_cast<double>(((moment % count) + count) % count) / count;
    const double way = motion.course == Course::turn ? share : share <= 0.5 ? 2 * share : 2 - 2 * share;
    return way == 1 ? motion.to : motion.from + (motion.to - motion.from) * way;
}

Scene moved(const Scene &scene, const Motion &motion, int moment) {
    Scene now = scene;
    const double value = value_at(motion, moment);
    switch (motion.mover) {
    case Mover::camera:
        now.camera = orbit_camera(scene.camera, value);
        expect_within(camera_coordinate, now.camera.position, motion);
        break;
    case Mover::light:
        orbit_light(thing(now.lights, motion, "light"), scene.camera, value);
        expect_within(coordinate, now.lights[motion.index].position, motion);
        expect_within(direction, now.lights[motion.index].direction, motion);
        break;
    case Mover::object:
        thing(now.objects, motion, "object").transform.rotate_degrees.y += value;
        break;
    case Mover::number: {
        const bool whole = number_at(scene, motion.path).whole;
        const std::string setting = fmt::format("{}={}", motion.path, whole ? std::round(value) : value);
        return with_settings(scene, {&setting, 1}, "motion", std::filesystem::current_path());
    }
    }
    return now;
}

std::vector<SceneNumber> numbers_of(const Scene &scene) {
    std::vector<SceneNumber> out;
    collect(scene, "", out);
    return out;
}

std::string motion_text(const Motion &motion) {
    ordered_json out{{"mover", mover_words[static_cast<std::size_t>(motion.mover)]}};
    if (motion.mover == Mover::number) {
        out["path"] = motion.path;
    } else if (motion.mover != Mover::camera) {
        out["index"] = motion.index;
    }
    out["from"] = motion.from;
    out["to"] = motion.to;
    out["seconds"] = motion.seconds;
    out["course"] = course_words[static_cast<std::size_t>(motion.course)];
    return out.dump();
}

Motion parse_motion(std::string_view json, std::string_view name) {
    const ordered_json from = read_json<ordered_json>(json, name);
    Motion motion;
    const char *key = "mover";
    try {
        motion.mover = parse_word<Mover>(from.at(key).get<std::string>(), mover_words);
        if (motion.mover == Mover::number) {
            motion.path = from.at(key = "path").get<std::string>();
        } else if (motion.mover != Mover::camera) {
            const ordered_json &index = from.at(key = "index");
            if (!index.is_number_unsigned()) {
                throw InputError("expected a whole number >= 0, got {}", short_json(index));
            }
            motion.index = index.get<std::size_t>();
        }
        motion.from = from.at(key = "from").get<double>();
        expect_degrees(motion, motion.from);
        motion.to = from.at(key = "to").get<double>();
        expect_degrees(motion, motion.to);
        motion.seconds = from.at(key = "seconds").get<double>();
        if (!(motion.seconds > 0 && motion.seconds <= longest_motion)) {
            throw InputError("expected above 0, at most {}", longest_motion);
        }
        motion.course = parse_word<Course>(from.at(key = "course").get<std::string>(), course_words);
    } catch (const InputError &error) {
        throw InputError("{}: motion.{}: {}", name, key, error.what());
    } catch (const ordered_json::exception &) {
        throw InputError("{}: motion.{}: missing, or of the wrong type", name, key);
    }
    return motion;
}

std::string motion_words(const Motion &motion) {
    switch (motion.mover) {
    case Mover::camera:
        return "camera orbits";
    case Mover::light:
        return fmt::format("light {} orbits", motion.index + 1);
    case Mover::object:
        return fmt::format("object {} turns", motion.index + 1);
    case Mover::number:
        break;
    }
    return motion.path;
}

} // namespace sandbox
