#pragma once

#include "scene/resources.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// The technique frequency `auto`: which triangles are lit per vertex, because that provably differs from per-pixel by
/// at most the technique's tolerance, and which per pixel.
namespace sandbox::certificate {

/// How a triangle is lit: values of ObjectChoice::per_vertex. A hidden one shows its back alone, which is culled: it
/// need not be drawn.
constexpr std::uint8_t per_pixel = 0, proved = 1, hidden = 2;

/// Of one object.
struct ObjectChoice {
    std::vector<std::uint8_t> per_vertex; ///< one per triangle
    std::size_t lit_per_vertex = 0;       ///< of the triangles whose front may be seen
    std::size_t facing = 0;               ///< ... and how many of those there are
    double area_per_vertex = 0, area = 0; ///< of the same, as seen from the eye (what hides what is not looked at)
    bool operator==(const ObjectChoice &) const = default;
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

/// `given` says how much the pictures may differ (tolerance) and by which equation; its frequency is not looked at.
/// `aspect`: width / height of the picture, which decides whether back faces can be seen.
Choice choose(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &given, double aspect);

} // namespace sandbox::certificate
