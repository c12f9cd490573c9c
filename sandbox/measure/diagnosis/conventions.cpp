#include "measure/diagnosis/conventions.h"

#include "scene/light_kind.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sandbox {
namespace {

constexpr const char *all_light = "factor";

struct TermName {
    const char *name;
    double Light::*intensity;
};
constexpr TermName terms[]{{"ambient", &Light::ambient}, {"diffuse", &Light::diffuse}, {"specular", &Light::specular}};

std::string light_name(std::size_t light) { return fmt::format("lights[{}]", light); }

/// Multiplies the part of that name.
void multiply(Scene &scene, const std::string &name, double factor) {
    const bool all = name == all_light;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        for (const TermName &term : terms) {
            if (all || name == term.name || name == light_name(i)) {
                scene.lights[i].*term.intensity *= factor;
            }
        }
    }
    if (all || name == terms[0].name) {
        scene.ambient *= factor;
    }
    for (Object &object : scene.objects) {
        object.material.emission *= all ? factor : 1;
    }
}

std::string words_of_factor(const std::string &name, double factor) {
    const std::string what = name == all_light           ? "all light"
                             : name.starts_with("light") ? "the light of " + name
                                                         : name + " light";
    if (factor == 0) {
        return what + " is missing";
    }
    return factor == 2 ? what + " is doubled" : fmt::format("{} is {:g} times the scene's", what, factor);
}

bool attenuates(const Light &light) { return has_position(light) && light.attenuation != Attenuation{}; }

} // namespace

std::vector<Reading> all_readings(bool bytes) {
    std::vector<Reading> readings;
    for (const bool clamped : {false, true}) {
        for (const bool flipped : {false, true}) {
            for (const Encoding encoding : {Encoding::linear, Encoding::srgb, Encoding::gamma}) {
                if (!clamped || !bytes) { // bytes are clamped anyway
                    readings.push_back({encoding, flipped, clamped});
                }
            }
        }
    }
    return readings;
}

std::vector<Convention> conventions_of(const Reading &reading) {
    std::vector<Convention> conventions;
    if (reading.encoding == Encoding::srgb) {
        conventions.push_back({"display=srgb", "the numbers are encoded by the sRGB curve, not linear light"});
    } else if (reading.encoding == Encoding::gamma) {
        conventions.push_back({"display=gamma-2.2", "the numbers are encoded with gamma 2.2, not linear light"});
    }
    if (reading.flipped) {
        conventions.push_back({"flipped", "the picture is upside down: its first row is the bottom one"});
    }
    if (reading.clamped) {
        conventions.push_back({"clamped", "light above white is cut to white"});
    }
    return conventions;
}

std::vector<Edit> scene_edits(const Scene &scene) {
    std::vector<Edit> edits;
    const auto add = [&](const char *name, const char *words, auto change) {
        Edit edit{scene, {{name, words}}};
        for (Light &light : edit.scene.lights) {
            change(light);
        }
        if (!(edit.scene == scene)) {
            edits.push_back(std::move(edit));
        }
    };
    add("attenuation=none", "attenuation is left out", [](Light &light) {
        if (attenuates(light)) {
            light.attenuation = {};
        }
    });
    add("cone=none", "the cones of spot lights are left out", [](Light &light) {
        if (light.type == LightType::spot) {
            light.cutoff_degrees = light.inner_cutoff_degrees = 180;
            light.exponent = 0;
        }
    });
    add("ambient=attenuated", "ambient light fades with the distance, as diffuse light does", [](Light &light) {
        if (attenuates(light) && light.ambient != 0) {
            light.attenuate_ambient = true;
        }
    });
    add("ambient=unattenuated", "ambient light does not fade with the distance",
        [](Light &light) { light.attenuate_ambient = false; });
    return edits;
}

Edit with_exponents(const Scene &scene, double factor) {
    Edit edit{scene,
              {{fmt::format("exponent={:g}", factor),
                fmt::format("exponents are {:g} times the scene's: shininess, or its scale", factor)}}};
    for (Object &object : edit.scene.objects) {
        object.material.shininess *= factor;
    }
    return edit;
}

std::vector<LinearParts> linear_parts(const Scene &scene) {
    std::vector<LinearParts> all;
    std::vector<std::vector<std::string>> ways{{all_light}, {}, {}};
    for (const TermName &term : terms) {
        ways[1].push_back(term.name);
    }
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        ways[2].push_back(light_name(i));
    }
    for (const std::vector<std::string> &names : ways) {
        LinearParts parts{scene, {}, {}};
        for (const std::string &name : names) {
            Scene without = parts.rest;
            multiply(without, name, 0);
            if (without == parts.rest) {
                continue;
            }
            Scene part = scene; // all but this goes dark
            for (const std::string &other : names) {
                if (other != name) {
                    multiply(part, other, 0);
                }
            }
            if (name != terms[0].name && name != all_light) {
                part.ambient = glm::dvec3(0);
            }
            for (Object &object : part.objects) {
                object.material.emission *= name == all_light ? 1 : 0;
            }
            parts.rest = std::move(without);
            parts.parts.push_back(std::move(part));
            parts.names.push_back(name);
        }
        if (!parts.parts.empty()) {
            all.push_back(std::move(parts));
        }
    }
    return all;
}

Edit with_factors(const Scene &scene, const LinearParts &parts, const std::vector<double> &factors) {
    Edit edit{scene, {}};
    for (std::size_t i = 0; i < factors.size(); ++i) {
        if (factors[i] != 1) {
            multiply(edit.scene, parts.names[i], factors[i]);
            edit.conventions.push_back(
                {fmt::format("{}={:g}", parts.names[i], factors[i]), words_of_factor(parts.names[i], factors[i])});
        }
    }
    return edit;
}

double plain_factor(double factor, double digits) {
    return std::round(std::clamp(factor, 0.0, 1000.0) * digits) / digits;
}

} // namespace sandbox
