#pragma once

#include "reference/kept_values.h"
#include "reference/lighting.h"
#include "reference/surface.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

/// The twin of precision=medium: the fragment stage of a specialised program on a half-float device, operation by
/// operation as shaders/ writes it. What is interpolated arrives in full.
namespace sandbox::reference {

/// What the rasteriser hands the stage at one pixel.
struct Varyings {
    glm::dvec3 position{0};              ///< from Setup::origin
    glm::dvec3 normal{0, 0, 1};          ///< as long as interpolation left it
    glm::dvec3 view{0};                  ///< interpolated-vectors: V
    glm::dvec3 light{0};                 ///< hybrid: the light of the vertices
    std::vector<LightVectors> vectors{}; ///< one for each of Setup::lights, where anything of them is interpolated
    glm::dvec2 uv{0};
    glm::dvec3 object_position{0};
    glm::dvec3 color{1}; ///< the vertices'
    bool colored = false;
    Side side = Side::front;
};

glm::dvec3 medium_color(const Setup &setup, const Object &object, const BaseColor &base, const Varyings &varyings);

} // namespace sandbox::reference
