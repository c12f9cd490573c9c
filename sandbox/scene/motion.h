#pragma once

#include "scene/scene_format.h"

#include <cstddef>
#include <string>
#include <vector>

/// A scene in motion: one thing of it moves, and moments follow each other at a fixed rate.
namespace sandbox {

enum class Mover {
    camera, ///< orbits its target
    light,  ///< orbits the camera's target: its position, its direction
    object, ///< turns about its own y axis, before what its scene turns it about z
    number, ///< any number of the scene
};
enum class Course {
    turn,      ///< from `from` to `to`, then again from `from`
    to_and_fro ///< from `from` to `to` and back, at a steady speed
};

struct Motion {
    Mover mover = Mover::light;
    std::size_t index = 0;        ///< of the light or the object
    std::string path{};           ///< Mover::number: as --set takes it, "lights[0].diffuse"
    double from = 0, to = 360;    ///< degrees about the camera's up, counter-clockwise seen from above; or the number
    double seconds = 8;           ///< of one round, (0, 600]
    Course course = Course::turn; ///< a round of to_and_fro ends where it began
    bool operator==(const Motion &) const = default;
};

constexpr int moments_a_second = 30;
constexpr double longest_motion = 600; ///< seconds

/// How many moments a round has, at least 2.
int moments_of(const Motion &motion);
/// The degrees or the number at a moment, which may be any whole number: moment 0 has `from`, and rounds repeat.
double value_at(const Motion &motion, int moment);
/// The scene at a moment; turned by 0 degrees it is the scene itself. Throws InputError if the light, the object or the
/// number is not there, or does not take the value.
Scene moved(const Scene &scene, const Motion &motion, int moment);

/// A number of a scene that has a control.
struct SceneNumber {
    std::string path;
    double value = 0;
    bool whole = false;
    Range range;
};
std::vector<SceneNumber> numbers_of(const Scene &scene);

/// As a JSON object: mover, index or path, from, to, seconds, course.
std::string motion_text(const Motion &motion);
/// Throws InputError naming `name` and the key.
Motion parse_motion(std::string_view json, std::string_view name);
/// "light 2 orbits", "objects[0].material.shininess".
std::string motion_words(const Motion &motion);

} // namespace sandbox
