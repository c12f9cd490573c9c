#pragma once

#include "scene/light_kind.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace sandbox {

/// Bit i: scene.lights[i].
using LightSet = std::uint64_t;
constexpr LightSet every_light = ~LightSet{0};

/// The terms of a light that no factor makes 0 on an object.
struct ShiningTerms {
    bool ambient, diffuse, specular;
};
ShiningTerms terms_on(const Object &object, const Light &light, Model model);

/// A light that reaches an object, and which of its terms are evaluated with it.
struct ObjectLight {
    std::size_t index; ///< in scene.lights
    bool ambient;      ///< an ambient term that is no part of the constant one: it asks whether the light is faced
    bool attenuated_ambient; ///< an ambient term times attenuation and cone
    bool diffuse, specular;
    double diffuse_factor = 1, specular_factor = 1; ///< of the normalisation
};

/// All light that reaches an object.
struct ObjectLights {
    ByLightKind<std::vector<ObjectLight>> of_kind; ///< by the kind that they are drawn as
    glm::dvec3 constant_ambient{0}; ///< times the material; of the scene and of lights whose ambient term is the same
                                    ///< everywhere
};

/// `seen`: no other light adds anything but constant ambient light.
ObjectLights lights_on_object(const Scene &scene, const Technique &technique, const Object &object,
                              LightSet seen = every_light);

/// How many times the diffuse light of a light the specular is, where both have one colour; 0 without diffuse light.
double specular_share(const Material &material, const Light &light, const ObjectLight &on_object);

bool has_soft_edge(const Light &light);
/// Is its cone or its soft edge too narrow for float32 cosines? Programs compare sines then.
bool is_narrow_cone(const Light &light);

/// Does anything about the light depend on where it is?
bool fades(const Light &light);
/// Must its ambient term be evaluated with the light? The rest is summed into one constant.
bool ambient_with_light(const Light &light, const Technique &technique);

} // namespace sandbox
