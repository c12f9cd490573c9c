#pragma once

#include "scene/scene.h"
#include "shading/technique.h"

#include <cstddef>

/// Which numbers of a scene can change the picture under either of two techniques: a slider for each of these and for
/// no other. What counts is what the equation reads, not the value: a term that stands at 0 keeps its slider.
namespace sandbox {

struct LightControls {
    bool intensities = false; ///< colour, ambient, diffuse: all that a light which is on has
    bool specular = false;
    bool position = false;
    bool direction = false;
    bool attenuation = false;
    bool attenuate_ambient = false;
    bool cone = false;       ///< the switch between a cone and none
    bool cone_shape = false; ///< cutoff, inner cutoff, exponent
    bool operator==(const LightControls &) const = default;
};

struct MaterialControls {
    bool diffuse = false; ///< ambient and emission are always usable
    bool specular = false;
    bool shininess = false;
    bool modulates_specular = false; ///< "texture colours the highlight": needs a texture or a chequer
    bool checker = false;            ///< its cells and colours
    bool operator==(const MaterialControls &) const = default;
};

struct SceneControls {
    bool blinn_exponent_scale = false;
    bool operator==(const SceneControls &) const = default;
};

LightControls light_controls(const Light &light, const Technique &left, const Technique &right);
MaterialControls material_controls(const Scene &scene, std::size_t object, const Technique &left,
                                   const Technique &right);
SceneControls scene_controls(const Scene &scene, const Technique &left, const Technique &right);

/// What one value of a technique key is good for, under the other keys of a technique.
enum class ValueUse {
    refused,   ///< the frequency, the model or another key rules it out
    no_effect, ///< nothing in this scene shows it
    open
};
ValueUse value_use(const TechniqueKey &key, int value, const Scene &scene, Technique technique);
/// May the value be clicked? Where it is open, and where it is set, so that it can be seen and left.
bool value_open(const TechniqueKey &key, int value, const Scene &scene, const Technique &technique);

} // namespace sandbox
