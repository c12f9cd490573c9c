#pragma once

#include "scene/scene.h"
#include "shading/technique.h"

namespace sandbox {

/// One light as the programs want it: colours already multiplied by the material, directions unit, cosines in double.
struct LightValues {
    int type = 0;           ///< full program: 0 directional, 1 point, 2 spot
    glm::dvec3 position{0}; ///< from the eye
    glm::dvec3 direction{0};
    glm::dvec3 ambient{0}, attenuated_ambient{0}, diffuse{0}, specular{0};
    glm::dvec3 half_vector{0};
    Attenuation attenuation;
    double cos_cutoff = -2; ///< below every cosine: no cone
    double cos_inner_cutoff = -2;
    double sin2_cutoff = 1;    ///< the square of the cutoff's sine
    double edge_sharpness = 0; ///< 1 / (cos_inner_cutoff - cos_cutoff); 0: a hard edge
    double exponent = 0;
};

/// `scale` multiplies every length (see Placing).
LightValues light_values(const Light &light, const Scene &scene, const Technique &technique, const Material &material,
                         double scale = 1);

/// material.ambient * (scene.ambient + every light's ambient that needs neither position nor facing).
glm::dvec3 constant_ambient_light(const Scene &scene, const Technique &technique, const Material &material);

} // namespace sandbox
