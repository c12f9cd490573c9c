#pragma once

#include "render/uploader.h"
#include "scene/scene.h"
#include "shading/eye_space.h"
#include "shading/object_lights.h"

namespace sandbox {

/// One light as the programs want it: colours already multiplied by the material, directions unit, cosines in double.
struct LightValues {
    glm::dvec3 position{0}; ///< where `space` measures lighting from
    glm::dvec3 direction{0};
    glm::dvec3 ambient{0}, attenuated_ambient{0}, diffuse{0}, specular{0};
    double specular_share = 0; ///< specular over diffuse, where they have one colour
    glm::dvec3 half_vector{0};
    Attenuation attenuation;
    double cos_cutoff = -2; ///< below every cosine: no cone
    double cos_inner_cutoff = -2;
    double sin2_cutoff = 1;    ///< the square of the cutoff's sine
    double edge_sharpness = 0; ///< 1 / (cos_inner_cutoff - cos_cutoff); 0: a hard edge
    double exponent = 0;
};

LightValues light_values(const Scene &scene, const ObjectLight &on_object, const Material &material,
                         const EyeSpace &space);

/// What lights of a kind may share, each name after `prefix`: "point_", or "point_lights[0].".
void put_shared(UniformSink &sink, const std::string &prefix, const LightValues &light);

/// All of one light's members, below `name` ("point_lights[0]").
void put_light(UniformSink &sink, const std::string &name, const LightValues &light);

} // namespace sandbox
