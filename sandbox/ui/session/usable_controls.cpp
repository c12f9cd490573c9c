#include "ui/session/usable_controls.h"

#include <algorithm>

namespace sandbox {

namespace {

bool has_specular(const Technique &left, const Technique &right) {
    return reflection(left.model).specular || reflection(right.model).specular;
}

bool any_light(const Scene &scene) { return std::ranges::any_of(scene.lights, &Light::enabled); }

bool is_positional(const Light &light) { return light.type != LightType::directional; }

} // namespace

LightControls light_controls(const Light &light, const Technique &left, const Technique &right) {
    LightControls can;
    if (!light.enabled) {
        return can; // a light that is off counts as absent
    }
    can.intensities = true;
    can.specular = has_specular(left, right);
    can.position = is_positional(light);
    can.direction = light.type != LightType::point;
    can.attenuation = is_positional(light);
    can.attenuate_ambient = is_positional(light);
    can.cone = light.type == LightType::spot;
    can.cone_shape = can.cone && light.cutoff_degrees != 180; // without a cone the exponent is dropped too
    if (can.cone && !can.cone_shape) {
        can.direction = false;
    }
    return can;
}

MaterialControls material_controls(const Scene &scene, std::size_t object, const Technique &left,
                                   const Technique &right) {
    const Material &material = scene.objects[object].material;
    MaterialControls can;
    can.diffuse = any_light(scene);
    can.specular = can.diffuse && has_specular(left, right);
    can.shininess = can.specular;
    can.checker = material.checker.has_value();
    can.modulates_specular = can.specular && (can.checker || !material.texture.empty());
    return can;
}

SceneControls scene_controls(const Scene &scene, const Technique &left, const Technique &right) {
    SceneControls can;
    can.blinn_exponent_scale =
        any_light(scene) && (reflection(left.model).scaled_exponent || reflection(right.model).scaled_exponent);
    return can;
}

ValueUse value_use(const TechniqueKey &key, int value, const Scene &scene, Technique technique) {
    key.set(technique, value);
    if (why_refused(technique)) {
        return ValueUse::refused;
    }
    return can_matter(key, value, scene, technique) ? ValueUse::open : ValueUse::no_effect;
}

bool value_open(const TechniqueKey &key, int value, const Scene &scene, const Technique &technique) {
    return key.get(technique) == value || value_use(key, value, scene, technique) == ValueUse::open;
}

} // namespace sandbox
