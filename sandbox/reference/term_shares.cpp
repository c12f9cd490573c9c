#include "reference/term_shares.h"

#include <utility>

namespace sandbox {

namespace {

constexpr std::pair<std::string_view, double Light::*> terms_of_a_light[]{
    {"ambient", &Light::ambient}, {"diffuse", &Light::diffuse}, {"specular", &Light::specular}};

/// Every light off; with `own`, the scene keeps what shines without them.
Scene in_the_dark(Scene scene, bool own) {
    for (Light &light : scene.lights) {
        light.enabled = false;
    }
    if (!own) {
        scene.ambient = glm::dvec3(0);
        for (Object &object : scene.objects) {
            object.material.emission = glm::dvec3(0);
        }
    }
    return scene;
}

} // namespace

std::vector<TermShare> term_shares(const Scene &scene, const std::vector<ObjectResources> &resources,
                                   const Technique &technique, Size size, int x, int y) {
    const auto color = [&](const Scene &lit) { return probe_pixel(lit, resources, technique, size, x, y); };
    const auto own = color(in_the_dark(scene, true));
    if (!own) {
        return {};
    }
    std::vector<TermShare> shares{{{}, "ambient", own->color}};
    const Scene dark = in_the_dark(scene, false);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        for (const auto &[name, intensity] : terms_of_a_light) {
            if (!scene.lights[i].enabled || scene.lights[i].*intensity == 0) {
                continue;
            }
            Scene lit = dark;
            Light &light = lit.lights[i];
            light = scene.lights[i];
            light.ambient = light.diffuse = light.specular = 0;
            light.*intensity = scene.lights[i].*intensity;
            shares.push_back({i, name, color(lit)->color});
        }
    }
    return shares;
}

} // namespace sandbox
