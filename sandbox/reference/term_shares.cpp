#include "reference/term_shares.h"

#include <utility>

namespace sandbox {

namespace {

constexpr std::pair<std::string_view, double Light::*> terms_of_a_light[]{
    {term_names[0], &Light::ambient}, {term_names[1], &Light::diffuse}, {term_names[2], &Light::specular}};

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

/// The light shines by one of its terms alone.
void keep_term(Light &light, double Light::*intensity) {
    const double kept = light.*intensity;
    light.ambient = light.diffuse = light.specular = 0;
    light.*intensity = kept;
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
            keep_term(light, intensity);
            shares.push_back({i, name, color(lit)->color});
        }
    }
    return shares;
}

std::vector<glm::dvec3> term_row(const Scene &scene, const std::vector<ObjectResources> &resources,
                                 const Technique &technique, Size size, int y, std::string_view term) {
    Scene lit = in_the_dark(scene, term == term_names[0]);
    for (const auto &[name, intensity] : terms_of_a_light) {
        for (std::size_t i = 0; i < scene.lights.size() && name == term; ++i) {
            lit.lights[i].enabled = scene.lights[i].enabled && scene.lights[i].*intensity != 0;
            keep_term(lit.lights[i], intensity);
        }
    }
    std::vector<glm::dvec3> colors;
    for (const auto &color : reference_row(lit, resources, technique, size, y)) {
        colors.push_back(color.value_or(glm::dvec3(0)));
    }
    return colors;
}

} // namespace sandbox
