#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string_view>

/// What can be drawn over every picture of a scene, a row each: flags, sidecars, switches, keys and menu read them.
namespace sandbox {

struct Overlays {
    bool wireframe = false, normals = false, vertices = false, proved = false; ///< on surfaces, which hide them
    bool lights = false;                                                       ///< over all
    bool operator==(const Overlays &) const = default;
};

struct OverlayKind {
    bool Overlays::*on;
    std::string_view word;  ///< a flag of `capture`, a key of sidecars
    std::string_view title; ///< in the window
    std::string_view help;
    char key;
    glm::vec3 color{};          ///< linear RGB, of what is drawn on surfaces
    bool in_difference = false; ///< the same on both sides, and so in their difference, too
};

inline constexpr std::array overlay_kinds{
    OverlayKind{&Overlays::wireframe, "wireframe", "wireframe", "the triangles' edges", 'W', {0.9F, 0.9F, 0.9F}, true},
    OverlayKind{
        &Overlays::normals, "normals", "normals", "normals as each side transforms them", 'N', {0.1F, 0.8F, 1.0F}},
    OverlayKind{&Overlays::vertices, "vertices", "vertices", "a dot at each vertex", 'V', {1.0F, 0.7F, 0.05F}},
    OverlayKind{&Overlays::proved,
                "proved",
                "lit per vertex",
                "stripes where the frequency auto has proved that lighting the vertices is enough",
                'Q',
                {0.1F, 0.9F, 0.3F}},
    OverlayKind{&Overlays::lights, "lights", "lights in the pictures", "lamps, cones and directions of light", 'I'},
};

} // namespace sandbox
