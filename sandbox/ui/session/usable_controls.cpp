#include "ui/session/usable_controls.h"

#include <algorithm>
#include <string_view>

namespace sandbox {

namespace {

bool has_specular(const Technique &left, const Technique &right) {
    return left.model != Model::lambert || right.model != Model::lambert;
}

bool any_light(const Scene &scene, bool (*is)(const Light &)) {
    return std::ranges::any_of(scene.lights, [is](const Light &light) { return light.enabled && is(light); });
}

bool any_light(const Scene &scene) {
    return any_light(scene, [](const Light &) { return true; });
}

bool has_place(const Light &light) { return light.type != LightType::directional; }
bool has_no_place(const Light &light) { return !has_place(light); }

/// Only specular light and two-sided objects ask where the viewer is.
bool reads_viewer(const Scene &scene, const Technique &technique) {
    return technique.model != Model::lambert || std::ranges::any_of(scene.objects, &Object::two_sided);
}

/// Does anything in the scene ask for this key? Keys not named here belong to the technique alone.
bool matters(std::string_view key, const Scene &scene, const Technique &technique) {
    if (key == "frequency" || key == "model" || key == "program") {
        return true;
    }
    if (key == "direction") {
        return any_light(scene, has_no_place);
    }
    if (key == "attenuation") {
        return any_light(scene, has_place);
    }
    if (key == "viewer") {
        return any_light(scene) && reads_viewer(scene, technique);
    }
    if (key == "position") {
        return any_light(scene, has_place) || (any_light(scene) && reads_viewer(scene, technique));
    }
    if (key == "power") {
        const auto has_exponent = [](const Light &light) { return light.type == LightType::spot; };
        return any_light(scene, has_exponent) || (any_light(scene) && technique.model != Model::lambert);
    }
    return any_light(scene);
}

} // namespace

LightControls light_controls(const Light &light, const Technique &left, const Technique &right) {
    LightControls can;
    if (!light.enabled) {
        return can; // a light that is off counts as absent
    }
    can.intensities = true;
    can.specular = has_specular(left, right);
    can.position = has_place(light);
    can.direction = light.type != LightType::point;
    can.attenuation = has_place(light);
    can.attenuate_ambient = has_place(light);
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
        any_light(scene) && (left.model == Model::blinn_phong || right.model == Model::blinn_phong);
    return can;
}

bool value_open(const TechniqueKey &key, int value, const Scene &scene, const Technique &technique) {
    if (key.get(technique) == value) {
        return true;
    }
    Technique changed = technique;
    key.set(changed, value);
    return !why_refused(changed) && matters(key.name, scene, technique);
}

} // namespace sandbox
