#include "reference/lighting.h"
#include "render/light_values.h"
#include "render/probe_vectors.h"
#include "render/shader_probe.h"
#include "scene/light_kind.h"
#include "scene/mesh.h"
#include "shading/prepared_object.h"
#include "tools/gl_test.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <sstream>

/// point_light, spot_light and directional_light, with all that they can hold, against light_terms in double.
namespace sandbox {
namespace {

class LightProbes : public GlTest {};

struct LightCase {
    std::string name;
    Light light;
    std::string technique = "per-pixel/blinn-phong";
    double shininess = 32;
};

/// in0 light position, in1 P, in2 N, in3 V, in4 direction of travel.
constexpr std::size_t position = 0, point = 1, normal = 2, view = 3, travel = 4;

std::vector<ProbeInput> light_inputs(const Light &light, int count) {
    Vectors random(29);
    std::vector<ProbeInput> inputs;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 n = random.direction();
        const glm::vec3 p = 2.0F * random.in_cube();
        const float distances[] = {1, 3, 1e-3F, 1e3F, 1e9F};
        glm::vec3 to_light = distances[i % 5] * random.direction();
        if (i % 7 == 0) {
            to_light = (i % 14 == 0 ? 0.0F : -1.0F) * n; // on the surface; straight behind it
        }
        const glm::vec3 at = p + to_light;
        const glm::vec3 l = at == p ? n : glm::normalize(at - p);
        const float spread = std::pow(10.0F, -1.5F + 1.5F * random.number());
        const glm::vec3 v =
            i % 3 == 0 ? random.direction() : glm::normalize(2 * glm::dot(n, l) * n - l + spread * random.in_cube());
        glm::vec3 d = glm::normalize(-l + spread * random.in_cube());
        if (light.type == LightType::directional) {
            d = i % 4 == 0 ? -n : random.direction();
        }
        inputs.push_back({glm::vec4(at, 0), glm::vec4(p, 0), glm::vec4(n, 0), glm::vec4(v, 0), glm::vec4(d, 0)});
    }
    return inputs;
}

/// "vec3 P, vec3 N" to "P, N".
std::string names_of(const std::string &parameters) {
    std::istringstream words(parameters);
    std::string names;
    for (std::string word; words >> word;) {
        names += word != "vec3" && word != "float" ? " " + word : "";
    }
    std::replace(names.begin(), names.end(), ',', ' ');
    std::istringstream list(names);
    std::string joined;
    for (std::string name; list >> name;) {
        joined += ", " + name;
    }
    return joined;
}

Scene scene_of(const LightCase &c) {
    Scene scene;
    scene.camera.position = {0, 0, 0};
    scene.camera.target = {0, 0, -1};
    scene.lights = {c.light};
    Object object{"ball", SphereShape{4, 4, 8}, {}, {}, false}; // around the light: it may touch the surface
    object.material.ambient = {0.5, 0.25, 1};
    object.material.diffuse = {1, 0.5, 0.75};
    object.material.specular = {0.75, 1, 0.5};
    object.material.shininess = c.shininess;
    scene.objects = {object};
    return scene;
}

struct Twin {
    glm::dvec3 color{0};
    bool undecided = false; ///< a gate or a hard cone that rounding may open or shut
};

/// `stable`: some power measures the angle between its vectors; a textbook power feels their lengths.
Twin twin_of(const Scene &scene, const Technique &technique, bool stable, const ProbeInput &in) {
    const Light &light = scene.lights[0];
    const Material &material = scene.objects[0].material;
    const reference::Setup setup = reference::prepare(scene, technique);
    reference::LightSetup one = setup.lights[0];
    const auto vector = [&](std::size_t k) { return glm::dvec3(in[k].x, in[k].y, in[k].z); };
    one.position = vector(position);
    one.travel = vector(travel);
    glm::dvec3 n = vector(normal);
    glm::dvec3 v = vector(view);
    if (stable) {
        one.travel = unit(one.travel);
        n = unit(n);
        v = unit(v);
    }
    const auto vectors = reference::light_vectors(setup, one, vector(point), n, v);
    const auto terms = reference::light_terms(setup, one, vectors, n, v, material.shininess);
    Twin twin;
    twin.color = material.diffuse * terms.diffuse + material.specular * terms.specular;
    if (ambient_with_light(light, technique)) {
        twin.color += material.ambient * terms.ambient;
    }
    constexpr double rounding = 6e-7; // ten units in the last place of 1
    const bool facing_decides = technique.gate == Gate::light_facing || technique.ambient == AmbientWhere::where_lit;
    const bool hard = one.cone && one.cos_inner == one.cos_outer;
    twin.undecided = (facing_decides && std::abs(terms.n_dot_l) < rounding) ||
                     (technique.gate == Gate::view_facing && std::abs(glm::dot(n, v)) < rounding) ||
                     (hard && std::abs(terms.c - one.cos_outer) < rounding);
    return twin;
}

void probe_light(const LightCase &c) {
    const Scene scene = scene_of(c);
    const Technique technique = parse_technique(c.technique);
    const PreparedObject prepared =
        prepare_object(scene, technique, scene.objects[0], build_mesh(scene.objects[0].mesh));
    const Features &features = prepared.program;
    const TemplateValues values = template_values(features, derive_needs(features), Stage::fragment);
    const LightType type = drawn_type(c.light);
    const std::string kind(kind_of(type).word);
    std::string body = values.texts.at(kind + ".type") + " light = the_" + kind +
                       "_light; vec3 P = in1.xyz; vec3 N = in2.xyz; vec3 V = in3.xyz; vec3 R = reflect(-V, N);\n";
    body += kind_of(type).positional ? "light.position = in0.xyz;\n" : "";
    body += kind_of(type).directed ? "light.direction = in4.xyz;\n" : "";
    body += "result.rgb = " + kind + "_light(light" + names_of(values.texts.at(kind + ".parameters")) + ");";
    const ShaderProbe probe(part_text("lighting.glsl", features), body);
    const std::vector<ProbeInput> inputs = light_inputs(c.light, 3000);
    const auto got = probe.run(inputs, [&](const GlProgram &program) {
        Uploader uploader(program);
        put_light(uploader, "the_" + kind + "_light",
                  light_values(scene, prepared.lights.of_kind[type].at(0), scene.objects[0].material, prepared.space));
        uploader.put("shininess",
                     static_cast<float>(raised_exponent(scene, technique.model, scene.objects[0].material)));
    });
    // The powers' bounds, which leave room for some ten more roundings of a colour; errors of what attenuation makes
    // large are relative to it.
    const bool stable_highlight = features.exponent == Exponent::stable;
    const double n =
        std::max(stable_highlight ? 0 : c.shininess, features.lights[type].stable_exponent ? 0 : c.light.exponent);
    const double stiff =
        std::max(stable_highlight ? c.shininess : 0, features.lights[type].stable_exponent ? c.light.exponent : 0);
    ProbeTable table(c.name, textbook_bound(n) + (stiff > 0 ? stable_bound(stiff) : 0));
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const Twin twin = twin_of(scene, technique, stiff > 0, inputs[i]);
        if (twin.undecided) {
            table.undecided();
        } else {
            table.compare(got[i], twin.color, inputs[i]);
        }
    }
}

Light full_light(LightType type) {
    Light light;
    light.type = type;
    light.color = {1, 0.5, 0.25};
    light.ambient = 0.25;
    light.diffuse = 0.75;
    light.attenuate_ambient = type != LightType::directional;
    return light;
}

TEST_F(LightProbes, PointLight) {
    Light light = full_light(LightType::point);
    probe_light({"point_light", light});
    light.attenuation = {0.2, 0.1, 0.05};
    probe_light({"point_light, attenuated", light});
    probe_light({"point_light, attenuated, phong", light, "per-pixel/phong"});
    probe_light({"point_light, attenuated, lambert", light, "per-pixel/lambert"});
    probe_light({"point_light, attenuated, n = 0", light, "per-pixel/blinn-phong", 0});
    probe_light({"point_light, attenuated, n = 1", light, "per-pixel/phong", 1});
    probe_light({"point_light, attenuated, stiff", light, "per-pixel/phong", 1024});
    probe_light({"point_light, view-facing", light, "per-pixel/blinn-phong:gate=view-facing"});
    probe_light({"point_light, no gate", light, "per-pixel/phong:gate=none"});
    probe_light({"point_light, where-lit", light, "per-pixel/blinn-phong:ambient=where-lit"});
    probe_light({"point_light, constant half vector", light, "per-pixel/blinn-phong:half_vector=constant"});
    light.attenuation = {0, 0, 1}; // 1 / d^2, as far as the floor
    probe_light({"point_light, 1 / d^2", light});
    light.attenuation = {0, 1e-30, 0};
    probe_light({"point_light, at the floor", light});
}

TEST_F(LightProbes, SpotLight) {
    Light light = full_light(LightType::spot);
    light.cutoff_degrees = light.inner_cutoff_degrees = 25;
    probe_light({"spot_light, hard", light});
    light.inner_cutoff_degrees = 5;
    probe_light({"spot_light, soft", light});
    light.attenuation = {0.5, 0, 0.1};
    for (const double exponent : {1.0, 8.0, 128.0, 1024.0, 1e5}) {
        light.exponent = exponent;
        probe_light({"spot_light, soft, exponent " + std::to_string(static_cast<int>(exponent)), light});
    }
    light.exponent = 8;
    light.cutoff_degrees = light.inner_cutoff_degrees = 90;
    probe_light({"spot_light, 90 degrees", light, "per-pixel/phong"});
    light.cutoff_degrees = light.inner_cutoff_degrees = 180; // a point light
    probe_light({"spot_light, 180 degrees", light});
}

TEST_F(LightProbes, DirectionalLight) {
    const Light light = full_light(LightType::directional);
    probe_light({"directional_light", light});
    probe_light({"directional_light, phong", light, "per-pixel/phong"});
    probe_light({"directional_light, stiff", light, "per-pixel/phong", 1024});
    probe_light({"directional_light, unnegated", light, "per-pixel/lambert:direction=unnegated-diffuse"});
    probe_light({"directional_light, constant half vector", light, "per-pixel/blinn-phong:half_vector=constant"});
}

} // namespace
} // namespace sandbox
