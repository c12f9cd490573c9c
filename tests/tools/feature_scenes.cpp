#include "tools/feature_scenes.h"

namespace sandbox {
namespace {

Light directional() {
    Light light;
    light.type = LightType::directional;
    light.direction = {0.3, -1, -0.5};
    return light;
}

Light point() {
    Light light;
    light.position = {1, 2, 3};
    return light;
}

Light attenuated_point() {
    Light light = point();
    light.color = {1, 0.5, 0.25};
    light.ambient = 0.2;
    light.attenuate_ambient = true;
    light.attenuation = {0.2, 0.1, 0.1};
    return light;
}

Light spot() {
    Light light = point();
    light.type = LightType::spot;
    light.direction = {-1, -2, -3};
    light.cutoff_degrees = light.inner_cutoff_degrees = 25;
    return light;
}

Light soft_spot() {
    Light light = spot();
    light.ambient = 0.1;
    light.inner_cutoff_degrees = 10;
    light.exponent = 8;
    light.attenuation = {1, 0, 0.05};
    return light;
}

Scene scene_of(const std::string &name, std::vector<Light> lights) {
    Scene scene;
    scene.name = name;
    scene.lights = std::move(lights);
    scene.objects = {{"ball", SphereShape{1, 16, 24}, {}, {}, false}};
    return scene;
}

} // namespace

std::vector<Scene> feature_scenes() {
    std::vector<Scene> scenes{scene_of("dark", {}),
                              scene_of("directional", {directional()}),
                              scene_of("point", {point()}),
                              scene_of("attenuated point", {attenuated_point()}),
                              scene_of("spot", {spot()}),
                              scene_of("soft spot", {soft_spot()}),
                              scene_of("all", {directional(), attenuated_point(), point(), spot(), soft_spot()})};
    Scene textured = scene_of("textured", {attenuated_point(), directional()});
    textured.objects[0].material.texture = "checker.png";
    textured.objects[0].material.texture_modulates_specular = false;
    textured.objects[0].material.emission = {0.1, 0, 0};
    textured.objects[0].transform.scale = {1, 0.5, 1};
    textured.objects[0].transform.rotate_degrees = {20, 30, 0};
    scenes.push_back(textured);
    Scene chequered = scene_of("chequered", {point(), soft_spot()});
    chequered.ambient = {0.1, 0.1, 0.1};
    chequered.objects[0].material.checker = Checker{};
    chequered.objects[0].transform.rotate_degrees = {0, 40, 0};
    scenes.push_back(chequered);
    Scene two_sided = scene_of("two-sided", {point(), directional()});
    two_sided.objects[0].mesh = PlaneShape{{2, 2}, 4};
    two_sided.objects[0].transform.rotate_degrees = {120, 0, 0};
    two_sided.objects[0].two_sided = true;
    two_sided.objects[0].material.shininess = 1;
    scenes.push_back(two_sided);
    Scene pipe = scene_of("open pipe", {point(), directional()}); // coarse: normals lean away where its front is seen
    CylinderShape open{0.8, 1.2, 9, 2};
    open.caps = false;
    pipe.objects[0].mesh = open;
    pipe.objects[0].two_sided = true;
    scenes.push_back(pipe);
    Scene stiff = scene_of("stiff", {point(), directional()});
    stiff.objects[0].material.shininess = 5000;
    scenes.push_back(stiff);
    Scene mirrored = scene_of("mirrored", {directional()});
    mirrored.objects[0].transform.scale = {-1, 1, 1};
    scenes.push_back(mirrored);
    return scenes;
}

} // namespace sandbox
