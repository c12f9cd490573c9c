#pragma once

#include "scene/resources.h"
#include "scene/scene.h"
#include "shading/object_lights.h"
#include "shading/technique.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// The technique frequency `auto`: which triangles are lit per vertex, because that provably differs from per-pixel by
/// at most the technique's tolerance, and which per pixel.
namespace sandbox::certificate {

/// Triangles of one object that are drawn alike.
struct Part {
    Frequency frequency = Frequency::per_pixel;
    LightSet lights = every_light; ///< of the scene: no other adds anything to them
    bool operator==(const Part &) const = default;
};

/// Of one object.
struct ObjectChoice {
    /// Of a triangle that shows its back alone, which is culled: it need not be drawn.
    static constexpr std::uint8_t hidden = 255;

    std::vector<Part> parts = std::vector<Part>(1);
    std::vector<std::uint8_t> part_of{};  ///< one per triangle: index in parts, or hidden
    std::size_t lit_per_vertex = 0;       ///< of the triangles whose front may be seen
    std::size_t facing = 0;               ///< ... and how many of those there are
    double area_per_vertex = 0, area = 0; ///< of the same, as seen from the eye (what hides what is not looked at)
    bool operator==(const ObjectChoice &) const = default;

    [[nodiscard]] bool shows(std::size_t triangle) const { return part_of[triangle] != hidden; }
    /// Of a triangle that shows.
    [[nodiscard]] const Part &part(std::size_t triangle) const { return parts[part_of[triangle]]; }
};

struct Choice {
    std::vector<ObjectChoice> objects;
    double bound = 0; ///< the largest of any triangle that is lit per vertex, in linear units
    double milliseconds = 0;
    const char *nothing_proved = ""; ///< why all is per pixel, where the technique decides that; else ""

    [[nodiscard]] double share() const; ///< of the area seen that is lit per vertex, in [0, 1]
};

/// An object of which less is proved is lit per pixel as a whole: two draws would cost more than they save.
constexpr double least_share = 0.25;
/// A draw of its own for what few lights reach saves more than this share of the object's pixels times lights.
constexpr double least_saved = 0.05;
constexpr std::size_t most_light_groups = 8;

/// `given` says how much the pictures may differ (tolerance) and by which equation; its frequency is not looked at.
/// `aspect`: width / height of the picture, which decides whether back faces can be seen.
Choice choose(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &given, double aspect);

} // namespace sandbox::certificate
