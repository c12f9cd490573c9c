#include "measure/stability/cases.h"

#include <iterator>

namespace sandbox {

std::vector<StabilityCase> stability_cases() {
    std::vector<StabilityCase> all;
    for (const auto group : {stability::exponent_cases, stability::geometry_cases, stability::attenuation_cases,
                             stability::spot_cases, stability::transform_cases, stability::vertex_cases,
                             stability::placement_cases, stability::magnitude_cases}) {
        auto cases = group();
        std::move(cases.begin(), cases.end(), std::back_inserter(all));
    }
    return all;
}

namespace stability {

Scene scene_of(const Shape &shape, std::vector<Light> lights) {
    Scene scene;
    scene.camera.position = {0, 0, 4};
    scene.lights = std::move(lights);
    scene.objects = {{"object", shape, {}, {}, false}};
    return scene;
}

Light point_light(const glm::dvec3 &position) {
    Light light;
    light.position = position;
    return light;
}

Light directional_light(const glm::dvec3 &direction) {
    Light light;
    light.type = LightType::directional;
    light.direction = direction;
    return light;
}

Light spot_light(const glm::dvec3 &position, const glm::dvec3 &direction, double cutoff_degrees) {
    Light light = point_light(position);
    light.type = LightType::spot;
    light.direction = direction;
    light.cutoff_degrees = light.inner_cutoff_degrees = cutoff_degrees;
    return light;
}

std::vector<Technique> techniques(std::initializer_list<const char *> texts) {
    std::vector<Technique> all;
    for (const char *text : texts) {
        all.push_back(parse_technique(text));
    }
    return all;
}

std::vector<Technique> usual_techniques() {
    return techniques(
        {"per-pixel/blinn-phong", "per-pixel/phong", "per-pixel/blinn-phong:program=full", "per-vertex/blinn-phong"});
}

std::vector<Technique> all_frequencies() {
    return techniques({"per-pixel/blinn-phong", "per-pixel/phong", "per-pixel/blinn-phong:program=full",
                       "per-vertex/blinn-phong", "flat/phong", "interpolated-vectors/blinn-phong",
                       "interpolated-vectors/phong", "hybrid/blinn-phong", "per-vertex/phong:program=full",
                       "interpolated-vectors/blinn-phong:program=full"});
}

} // namespace stability
} // namespace sandbox
