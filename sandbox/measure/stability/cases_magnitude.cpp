#include "measure/stability/cases.h"

#include <cmath>

namespace sandbox::stability {
namespace {

Scene lit_ball(std::size_t lights, double intensity) {
    Scene scene = scene_of(SphereShape{}, {});
    for (std::size_t i = 0; i < lights; ++i) {
        const double angle = 2.4 * static_cast<double>(i); // the golden angle spreads them
        Light light = point_light({3 * std::cos(angle), 3 * std::sin(angle), 3});
        light.color = glm::dvec3(intensity);
        light.ambient = 0.1;
        scene.lights.push_back(light);
    }
    return scene;
}

StabilityCase story(const char *group, const char *name, const Scene &scene, const char *symptom, const char *cause,
                    const char *source) {
    StabilityCase one;
    one.group = group;
    one.name = std::string(group) + "-" + name;
    one.symptom = symptom;
    one.cause = cause;
    one.source = source;
    one.scene = scene;
    one.techniques = usual_techniques();
    one.bound = one_level;
    one.unit = ErrorUnit::brightest_value;
    return one;
}

} // namespace

std::vector<StabilityCase> magnitude_cases() {
    std::vector<StabilityCase> cases;
    cases.push_back(story("magnitude", "64-lights-of-1e4", lit_ball(64, 1e4), "White plates with coloured rims.",
                          "A sum of 1e6 is beyond a half float's 65504: infinity.", "high dynamic range in RGBA16F"));
    Scene most = lit_ball(64, 1e6);
    most.objects[0].material.diffuse = most.objects[0].material.specular = glm::dvec3(1e6);
    for (Light &light : most.lights) {
        light.diffuse = light.specular = 1e6;
        light.attenuation = {0, 0, 1e-30};
    }
    cases.push_back(story("magnitude", "everything-1e6", most, "Infinity.",
                          "Every factor at its largest, 64 times: 1e6 ^ 4 * 64 = 6e25, within float32.",
                          "every slider at its end"));
    cases.push_back(story("magnitude", "lights-of-1e-30", lit_ball(3, 1e-30), "Black, or all of one colour.",
                          "1e-30 is a normal float32; its products with 1e-9 are not, and may be flushed to 0.",
                          "a lamp dimmed to almost nothing"));
    Scene mixed = lit_ball(2, 1);
    mixed.lights[0].color = {1e6, 1, 1e-6};
    mixed.lights[1].color = {0, 1e-6, 1e6};
    cases.push_back(story("magnitude", "1e6-beside-1e-6", mixed, "The dim channel is noise.",
                          "Channels must not share a rounding.", "coloured lamps of very different power"));
    Scene dark = lit_ball(3, 1);
    dark.lights[0].color = dark.lights[1].color = glm::dvec3(0);
    dark.objects[0].material.specular = {0, 1, 0};
    cases.push_back(story("magnitude", "colours-0", dark, "NaN where 0 meets infinity.",
                          "0 * infinity is NaN: a term of colour 0 is left out, not multiplied.",
                          "lamps switched off by their colour"));
    Scene glowing = lit_ball(2, 1);
    glowing.lights[0].color = {1e5, 1e-5, 0};
    glowing.lights[0].diffuse = 1e5;
    cases.push_back(story("display", "1e10", glowing, "The brightest parts turn black or change colour.",
                          "1e10 must reach 8 bits as 255: converted before it is clamped it overflows an integer.",
                          "a lamp inside the picture"));
    Scene hidden = lit_ball(1, 1);
    hidden.lights[0].attenuation = {0, 0, 1};
    hidden.lights[0].position = {0, 0, 1};
    hidden.lights[0].diffuse = 1e4;
    cases.push_back(story("display", "hidden-infinity", hidden, "Nothing is seen, and the averages are wrong.",
                          "Eight bits show an infinite or NaN pixel as white or black; in float it is counted, on the "
                          "screen it is painted magenta.",
                          "RGBA8 framebuffers"));
    return cases;
}

} // namespace sandbox::stability
