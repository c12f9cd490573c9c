#include "reference/lighting.h"
#include "reference/surface.h"
#include "render/light_values.h"
#include "render/probe_vectors.h"
#include "render/shader_probe.h"
#include "render/uniforms.h"
#include "scene/light_kind.h"
#include "scene/space.h"
#include "shading/prepared_object.h"
#include "tools/gl_test.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

/// surface_normal and surface_position of both kinds of program, and the lights of the full program.
namespace sandbox {
namespace {

class ProgramProbes : public GlTest {};

struct TransformCase {
    std::string name;
    Transform transform;
};

std::vector<TransformCase> transforms() {
    const glm::dvec3 turn(20, 130, -50);
    return {{"identity", {}},
            {"rigid", {{1, 2, 3}, turn, {1, 1, 1}}},
            {"uniform", {{0, 0, 0}, turn, {2.5, 2.5, 2.5}}},
            {"squashed", {{0, 1, 0}, turn, {1, 0.5, 2}}},
            {"mirrored", {{0, 0, 0}, turn, {-1, 1, 0.5}}},
            {"scale 1e-6", {{0, 0, 0}, turn, {1, 1e-6, 1}}},
            {"scale 0", {{0, 0, 0}, turn, {1, 0, 1}}},
            {"scale 1e-25", {{0, 0, 0}, turn, {1, 1e-25, 2}}},
            {"scale 1e13", {{0, 0, 0}, turn, {1e13, 2e13, 1e13}}},
            {"scale 1e-13", {{0, 0, 0}, turn, {1e-13, 2e-13, 1e-13}}}};
}

Scene surface_scene(const Transform &transform) {
    Scene scene;
    scene.camera.position = {0.3, 1.1, 4};
    scene.lights = {Light{}};
    scene.objects = {{"ball", SphereShape{1, 4, 8}, transform, {}, false}};
    return scene;
}

std::vector<ProbeInput> unit_vectors(int count) {
    Vectors random(5);
    std::vector<ProbeInput> inputs;
    for (int i = 0; i < count; ++i) {
        inputs.push_back({glm::vec4(random.direction(), 0), glm::vec4(random.in_cube(), 0)});
    }
    for (int axis = 0; axis < 6; ++axis) {
        glm::vec3 n(0);
        n[axis % 3] = axis < 3 ? 1.0F : -1.0F;
        inputs.push_back({glm::vec4(n, 0), glm::vec4(n, 0)});
    }
    return inputs;
}

glm::dmat4 camera_relative(const Scene &scene) {
    const Transform &transform = scene.objects[0].transform;
    glm::dmat4 model(linear_part(transform));
    model[3] = glm::dvec4(transform.translate - scene.camera.position, 1);
    return model;
}

void probe_normal(const TransformCase &c, const std::string &technique_text) {
    const Scene scene = surface_scene(c.transform);
    const Technique technique = parse_technique(technique_text);
    const Object &object = scene.objects[0];
    const PreparedObject prepared = prepare_object(scene, technique, object, build_mesh(object.mesh));
    const ShaderProbe probe("vec3 a_normal, a_position;\n" +
                                part_text("surface_vertex.glsl", prepared.program, Stage::vertex),
                            "a_normal = in0.xyz; a_position = in1.xyz; result.rgb = surface_normal();");
    const std::vector<ProbeInput> inputs = unit_vectors(2000);
    const auto got = probe.run(inputs, [&](const GlProgram &program) {
        Uploader uploader(program);
        uploader.put("model", glm::mat4(camera_relative(scene)));
        uploader.put("normal_matrix", glm::mat3(prepared.space.normals));
        put_choices(uploader, prepared.features);
    });
    // A matrix rounded to float32 and three products a component: 6 units in the last place of 1.
    ProbeTable table("surface_normal, " + c.name + (technique_text == "per-pixel/lambert" ? "" : ", " + technique_text),
                     6 * 0x1p-24);
    const glm::dmat3 matrix = reference::normal_matrix(linear_part(object.transform), technique.normals);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const glm::dvec3 n(inputs[i][0].x, inputs[i][0].y, inputs[i][0].z);
        // Where the matrix all but cancels, its own rounding is what is left: allowed in proportion.
        const double shrink = glm::length(matrix * n);
        table.compare(got[i], reference::transform_normal(matrix, n), inputs[i], std::max(1.0, 1 / shrink));
    }
}

TEST_F(ProgramProbes, SurfaceNormal) {
    for (const TransformCase &c : transforms()) {
        for (const char *technique : {"per-pixel/lambert", "per-pixel/lambert:normals=model-matrix",
                                      "per-pixel/lambert:normals=untransformed", "per-pixel/lambert:program=full"}) {
            probe_normal(c, technique);
        }
    }
}

TEST_F(ProgramProbes, SurfacePosition) {
    for (const char *technique_text : {"per-pixel/lambert", "per-pixel/lambert:position=w0"}) {
        const Scene scene = surface_scene({{1, 2, 3}, {20, 130, -50}, {1, 0.5, 2}});
        const Technique technique = parse_technique(technique_text);
        const Object &object = scene.objects[0];
        const PreparedObject prepared = prepare_object(scene, technique, object, build_mesh(object.mesh));
        const ShaderProbe probe("vec3 a_normal, a_position;\n" +
                                    part_text("surface_vertex.glsl", prepared.program, Stage::vertex),
                                "a_normal = in0.xyz; a_position = in1.xyz; result.rgb = surface_position();");
        const std::vector<ProbeInput> inputs = unit_vectors(2000);
        const auto got = probe.run(inputs, [&](const GlProgram &program) {
            Uploader uploader(program);
            uploader.put("model", glm::mat4(camera_relative(scene)));
            uploader.put("eye", glm::vec3(scene.camera.position));
        });
        ProbeTable table(std::string("surface_position, ") + technique_text, 6 * 0x1p-24 * 4); // of lengths up to 4
        const auto placement = reference::world_transform(object.transform, reference::prepare(scene, technique));
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            table.compare(got[i], placement.lit({inputs[i][1].x, inputs[i][1].y, inputs[i][1].z}), inputs[i]);
        }
    }
}

/// in0 P, in1 N, in2 V; the light lies still.
void probe_full_light(const std::string &name, const Light &light, const std::string &technique_text,
                      double shininess) {
    Scene scene;
    scene.camera.position = {0, 0, 0};
    scene.camera.target = {0, 0, -1};
    scene.lights = {light};
    scene.objects = {{"ball", SphereShape{}, {}, {}, false}};
    Material &material = scene.objects[0].material;
    material.ambient = {0.5, 0.25, 1};
    material.diffuse = {1, 0.5, 0.75};
    material.shininess = shininess;
    Technique technique = parse_technique(technique_text);
    technique.program = Program::full;
    const PreparedObject prepared =
        prepare_object(scene, technique, scene.objects[0], build_mesh(SphereShape{1, 4, 8}));
    const ShaderProbe probe(part_text("lighting.glsl", prepared.program),
                            "vec3 specular = vec3(0.0);\n"
                            "result.rgb = lighting(in0.xyz, in1.xyz, in2.xyz, specular);\n"
                            "result.rgb += specular;");
    const reference::Setup setup = reference::prepare(scene, technique);
    const reference::LightSetup &one = setup.lights[0];
    Vectors random(17);
    std::vector<ProbeInput> inputs;
    for (int i = 0; i < 3000; ++i) {
        const glm::vec3 p = i % 9 == 0 ? glm::vec3(light.position) : 2.0F * random.in_cube();
        const glm::vec3 n = random.direction();
        const glm::vec3 l(!has_position(light) ? -one.travel
                                               : unit(light.position - glm::dvec3(p) + glm::dvec3(0, 1e-9, 0)));
        const float spread = std::pow(10.0F, -1.5F + 1.5F * random.number());
        const glm::vec3 v =
            i % 3 == 0 ? random.direction() : glm::normalize(2 * glm::dot(n, l) * n - l + spread * random.in_cube());
        inputs.push_back({glm::vec4(p, 0), glm::vec4(n, 0), glm::vec4(v, 0)});
    }
    const auto got = probe.run(inputs, [&](const GlProgram &program) {
        Uploader uploader(program);
        put_light(uploader, "lights[0]",
                  light_values(scene, prepared.lights.of_kind[drawn_type(light)].at(0), material, prepared.space));
        uploader.put(std::string(kind_of(drawn_type(light)).word) + "_end", 1);
        uploader.put("ambient", glm::vec3(prepared.lights.constant_ambient));
        uploader.put("shininess", static_cast<float>(raised_exponent(scene, technique.model, material)));
        put_choices(uploader, prepared.features);
    });
    const bool stable = technique.power == Power::stable;
    ProbeTable table("full: " + name, stable ? 2e-5 + stable_bound(shininess) : textbook_bound(shininess));
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const glm::dvec3 p(inputs[i][0].x, inputs[i][0].y, inputs[i][0].z);
        const glm::dvec3 n = unit({inputs[i][1].x, inputs[i][1].y, inputs[i][1].z});
        const glm::dvec3 v = unit({inputs[i][2].x, inputs[i][2].y, inputs[i][2].z});
        const auto vectors = reference::light_vectors(setup, one, p, n, v);
        const auto terms = reference::light_terms(setup, one, vectors, n, v, material.shininess);
        if (std::abs(terms.n_dot_l) < 6e-7 || (one.cone && std::abs(terms.c - one.cos_outer) < 6e-7)) {
            table.undecided(); // a gate or a cone that rounding may open
            continue;
        }
        // Rounding of L + V weighs the more, the shorter H.
        const double h = glm::length(vectors.l + v);
        const double allowance = technique.model == Model::blinn_phong && h > 0 ? 1 + 0.5 / h : 1;
        table.compare(got[i], material.ambient * terms.ambient + material.diffuse * terms.diffuse + terms.specular,
                      inputs[i], allowance);
    }
}

TEST_F(ProgramProbes, FullProgramsLights) {
    Light light;
    light.color = {1, 0.5, 0.25};
    light.ambient = 0.25;
    light.position = {0.5, 1, -0.25};
    light.direction = {-0.4, -1, 0.3};
    light.attenuation = {0.2, 0.1, 0.05};
    light.attenuate_ambient = true;
    for (const char *model : {"per-pixel/lambert", "per-pixel/phong", "per-pixel/blinn-phong"}) {
        light.type = LightType::point;
        probe_full_light("point, " + std::string(model), light, model, 32);
        light.type = LightType::directional;
        probe_full_light("directional, " + std::string(model), light, model, 32);
        light.type = LightType::spot;
        light.cutoff_degrees = light.inner_cutoff_degrees = 40;
        light.exponent = 8;
        probe_full_light("hard spot, " + std::string(model), light, model, 32);
        light.inner_cutoff_degrees = 10;
        probe_full_light("soft spot, " + std::string(model), light, model, 32);
    }
    light.type = LightType::directional;
    for (const double n : {0.0, 1.0, 2.0, 1023.0}) {
        const std::string text = ", n = " + std::to_string(static_cast<int>(n));
        probe_full_light("phong" + text, light, "per-pixel/phong:power=textbook", n);
        probe_full_light("blinn-phong" + text, light, "per-pixel/blinn-phong:power=textbook", n);
    }
    for (const double n : {1024.0, 1e5, 1e7}) {
        const std::string text = ", stable, n = " + std::to_string(static_cast<int>(n));
        probe_full_light("phong" + text, light, "per-pixel/phong:power=stable", n);
        probe_full_light("blinn-phong" + text, light, "per-pixel/blinn-phong:power=stable", n);
    }
}

} // namespace
} // namespace sandbox
