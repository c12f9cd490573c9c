#include "shading/program_source.h"

#include "image/error.h"
#include "scene/resources.h"
#include "scene/scene_file.h"
#include "shading/prepared_object.h"
#include "tools/feature_scenes.h"
#include "tools/technique_walk.h"

#include <gtest/gtest.h>

#include <map>

namespace sandbox {
namespace {

const ShaderParts &parts() {
    static const ShaderParts result{Assets("shaders")};
    return result;
}

Features features_of(const Scene &scene, const std::string &technique) {
    const Object &object = scene.objects.at(0);
    return prepare_object(scene, parse_technique(technique), object, build_mesh(object.mesh)).program;
}

/// Both stages of the first object's program.
std::string text_of(const Scene &scene, const std::string &technique) {
    const ProgramSource source = assemble(features_of(scene, technique), parts());
    return source.vertex.text + source.fragment.text;
}

bool has(const std::string &text, const std::string &word) { return text.find(word) != std::string::npos; }

Scene named(const std::string &name) {
    for (const Scene &scene : feature_scenes()) {
        if (scene.name == name) {
            return scene;
        }
    }
    throw std::logic_error("no scene " + name);
}

TEST(ProgramText, DirectionalLambertHoldsNothingElse) {
    const std::string text = text_of(named("directional"), "per-pixel/lambert");
    for (const char *word : {"pow",    "for (",    "PointLight",    "SpotLight",   "uv",          "v_position",
                             "V =",    "half",     "shininess",     "specular",    "attenuation", "constant",
                             "cutoff", "ambient",  "normal_matrix", "mat4 model;", "inverse",     "texture",
                             "base",   "emission", "object_id",     "Fault"}) {
        EXPECT_FALSE(has(text, word)) << word << " in\n" << text;
    }
    EXPECT_TRUE(has(text, "max(n_dot_l, 0.0)"));
}

TEST(ProgramText, ABakedProgramMultipliesWholeExponentsAndWritesItsLightsOut) {
    Scene scene = named("all");
    const auto raised_to = [&](double n, const std::string &technique = "per-pixel/phong:program=baked") {
        scene.objects[0].material.shininess = n;
        return text_of(scene, technique);
    };
    const std::string hundred = raised_to(100); // 64 + 32 + 4
    EXPECT_TRUE(has(hundred, "float f2 = f * f, f4 = f2 * f2, f8 = f4 * f4, f16 = f8 * f8, f32 = f16 * f16, "
                             "f64 = f32 * f32;"));
    EXPECT_TRUE(has(hundred, "return f64 * f32 * f4;"));
    EXPECT_FALSE(has(hundred, "pow(max(dot(R, L)"));
    EXPECT_FALSE(has(hundred, "shininess"));
    EXPECT_TRUE(has(raised_to(3), "return f2 * f;"));
    for (const double by_pow : {2.5, 0.5}) {
        EXPECT_TRUE(has(raised_to(by_pow), "pow(max(dot(R, L), 0.0), shininess)")) << by_pow;
    }
    EXPECT_TRUE(has(raised_to(1024), "stable_power(0.5"));
    EXPECT_TRUE(has(raised_to(32, "per-pixel/phong:power=naive,program=baked"), "shininess"));
    EXPECT_FALSE(has(raised_to(32), "for (int"));
    EXPECT_TRUE(has(hundred, "point_light(point_lights[0], P, N, R) + point_light(point_lights[1], P, N, R)"));
}

/// H = 0 where L = -V: the object lies between the viewer and a light.
TEST(ProgramText, TheHalfVectorIsGuardedOnlyWhereALightMayStandOppositeTheViewer) {
    Scene scene = named("point");
    scene.objects[0].transform = {};
    scene.objects[0].mesh = SphereShape{};
    scene.camera.position = {0, 0, 5};
    const auto guarded = [&](const std::string &technique = "per-pixel/blinn-phong") {
        return has(text_of(scene, technique), "h2 > 0.0");
    };
    Light &light = scene.lights[0];
    for (const auto &[position, crosses] : std::initializer_list<std::pair<glm::dvec3, bool>>{
             {{0, 0, -5}, true}, {{4, 0, 5}, false}, {{0.5, 0.5, -3}, true}, {{0, 0, 3}, false}, {{6, 0, -5}, false}}) {
        light.position = position;
        EXPECT_EQ(guarded(), crosses) << position.x << " " << position.z;
    }
    EXPECT_TRUE(guarded("interpolated-vectors/blinn-phong")) << "what is interpolated may cancel";
    EXPECT_TRUE(guarded("per-pixel/blinn-phong:position=absolute"));
    scene.objects[0].transform.scale = glm::dvec3(1e-9); // float32 cannot tell it from a point on the line
    light.position = {1e-8, 0, -5};
    EXPECT_TRUE(guarded());
    scene.objects[0].transform.scale = glm::dvec3(1);
    light.type = LightType::directional;
    light.direction = {0, 0, 1}; // towards the viewer
    EXPECT_TRUE(guarded());
    light.direction = {0, -1, -1};
    EXPECT_FALSE(guarded());
}

TEST(ProgramText, OneColourServesDiffuseAndSpecularLightWhereTheyHaveTheSame) {
    Scene scene = named("point");
    Material &material = scene.objects[0].material;
    material.diffuse = {0.2, 0.4, 0.6};
    material.specular = {0.1, 0.2, 0.3};
    EXPECT_TRUE(has(text_of(scene, "per-pixel/blinn-phong"), "light.specular_share * highlight"));
    EXPECT_FALSE(has(text_of(scene, "hybrid/blinn-phong"), "specular_share")) << "its terms go to two stages";
    material.specular = {0.1, 0.2, 0.31};
    EXPECT_FALSE(has(text_of(scene, "per-pixel/blinn-phong"), "specular_share"));
}

/// Of the lights alone: a coloured material makes other shares of a red and a green lamp.
TEST(ProgramText, WhatLightsOfAKindShareIsOneUniform) {
    Scene scene = named("point");
    scene.lights[0].attenuation = {0.2, 0.1, 0.1};
    scene.lights.push_back(scene.lights[0]);
    scene.lights[0].color = {0.8, 0, 0};
    scene.lights[1].color = {0, 0.3, 0};
    scene.lights[1].position.x += 1;
    const auto text = [&] { return text_of(scene, "per-pixel/blinn-phong"); };
    EXPECT_TRUE(has(text(), "point_constant + d * (point_linear + point_quadratic * d)"));
    EXPECT_TRUE(has(text(), "point_specular_share * highlight"));
    scene.objects[0].material.diffuse = {1, 0.5, 0.5};
    EXPECT_TRUE(has(text(), "light.specular_share * highlight"));
    scene.lights[1].attenuation.linear = 0.2;
    EXPECT_TRUE(has(text(), "light.constant + d * (light.linear + light.quadratic * d)"));
    scene.objects[0].material.diffuse = {1, 1, 1};
    scene.lights[1].specular = 0.5;
    EXPECT_TRUE(has(text(), "light.specular_share * highlight"));
}

TEST(ProgramText, WhatASceneNeedsIsThere) {
    const std::string text = text_of(named("all"), "per-pixel/blinn-phong");
    EXPECT_TRUE(has(text, "pow(f2, 0.5 * shininess)"));
    EXPECT_TRUE(has(text, "for (int i = 0; i < 2; ++i)")); // two point lights, two spots
    EXPECT_TRUE(has(text, "the_directional_light"));
    EXPECT_TRUE(has(text, "smoothstep"));
    EXPECT_TRUE(has(text, "light.quadratic * d * d"));
    EXPECT_TRUE(has(text, "attenuated_ambient"));
}

/// Attribute, varying and line are there where the mesh has colours that light shows, under every frequency, and
/// nowhere else; in full programs, too.
TEST(ProgramText, VerticesColoursAreThereWhereTheMeshHasThem) {
    for (const char *name : {"all", "textured", "chequered"}) {
        const Scene scene = named(name);
        const Object &object = scene.objects[0];
        Mesh mesh = build_mesh(object.mesh);
        const auto text = [&](const Technique &technique) {
            const ProgramSource source = assemble(prepare_object(scene, technique, object, mesh).program, parts());
            return source.vertex.text + source.fragment.text;
        };
        for (const Frequency frequency : all_frequencies) {
            for (const Program program : {Program::specialised, Program::full}) {
                const Technique technique{.frequency = frequency, .program = program};
                mesh.colors.clear();
                EXPECT_FALSE(has(text(technique), "_color;")) << to_string(technique);
                mesh.colors.assign(mesh.positions.size(), glm::dvec3(1));
                const std::string colored = text(technique);
                EXPECT_TRUE(has(colored, "layout(location = 4) in vec3 a_color;")) << to_string(technique);
                EXPECT_TRUE(has(colored, "v_color = a_color;")) << to_string(technique);
                const bool alone = program != Program::full && std::string(name) == "all";
                EXPECT_TRUE(has(colored, alone ? "vec3 base = v_color;" : "base *= v_color;")) << to_string(technique);
            }
        }
    }
    Scene dark = named("all");
    dark.lights.clear(); // nothing is lit: no colour shows
    Mesh mesh = build_mesh(dark.objects[0].mesh);
    mesh.colors.assign(mesh.positions.size(), glm::dvec3(1));
    EXPECT_FALSE(prepare_object(dark, {}, dark.objects[0], mesh).program.colored);
}

TEST(ProgramText, ATermAtZeroIsLeftOut) {
    Scene scene = named("attenuated point");
    scene.lights[0].specular = 0;
    EXPECT_FALSE(has(text_of(scene, "per-pixel/phong"), "pow"));
    scene.lights[0].attenuation = {1, 0, 0};
    EXPECT_FALSE(has(text_of(scene, "per-pixel/phong"), "1.0 / "));
    scene.lights[0].attenuation = {1, 0, 0.5};
    EXPECT_FALSE(has(text_of(scene, "per-pixel/phong"), "linear"));
    scene.lights[0].enabled = false;
    EXPECT_FALSE(has(text_of(scene, "per-pixel/phong"), "PointLight"));
    scene = named("spot");
    scene.lights[0].cutoff_degrees = 180; // no cone: a point light
    EXPECT_FALSE(has(text_of(scene, "per-pixel/phong"), "Spot"));
}

TEST(ProgramText, NormalsGoThroughNoMoreThanTheyNeed) {
    Scene scene = named("directional");
    EXPECT_FALSE(has(text_of(scene, "per-pixel/phong:viewer=infinite"), "model;"));
    scene.objects[0].transform.rotate_degrees = {0, 30, 0};
    EXPECT_FALSE(has(text_of(scene, "per-pixel/phong"), "normal_matrix"));
    EXPECT_TRUE(has(text_of(scene, "per-pixel/phong"), "mat3(model)"));
    scene.objects[0].transform.scale = {1, 2, 1};
    EXPECT_TRUE(has(text_of(scene, "per-pixel/phong"), "normal_matrix"));
    EXPECT_TRUE(has(text_of(scene, "per-pixel/phong:normals=model-matrix"), "Fault"));
}

TEST(ProgramText, TheStablePowerIsThereOnlyWhereTheExponentNeedsIt) {
    Scene scene = named("point");
    scene.objects[0].material.shininess = 1023;
    EXPECT_FALSE(has(text_of(scene, "per-pixel/phong"), "stable_power"));
    scene.objects[0].material.shininess = 1024;
    EXPECT_TRUE(has(text_of(scene, "per-pixel/phong"), "stable_power"));
    EXPECT_FALSE(has(text_of(scene, "per-pixel/phong:power=textbook"), "stable_power"));
    scene.objects[0].material.shininess = 256;
    scene.blinn_exponent_scale = 4; // n as it is raised
    EXPECT_TRUE(has(text_of(scene, "per-pixel/blinn-phong"), "stable_power"));
    EXPECT_FALSE(has(text_of(scene, "per-pixel/phong"), "stable_power"));
}

TEST(ProgramText, GuardsOfExtremeScenesAreThereOnlyWhereTheyAreNeeded) {
    Scene scene = named("soft spot");
    const std::string plain = text_of(scene, "per-pixel/phong");
    for (const char *word : {"sin2_cutoff", "edge_sharpness", "gl_FragDepth", "gl_FragCoord", "ray_corner"}) {
        EXPECT_FALSE(has(plain, word)) << word;
    }
    scene.lights[0].cutoff_degrees = 0.5;
    scene.lights[0].inner_cutoff_degrees = 0.2;
    EXPECT_TRUE(has(text_of(scene, "per-pixel/phong"), "edge_sharpness"));
    scene = named("soft spot");
    scene.camera.near_plane = 1e-4;
    scene.camera.far_plane = 1e3;
    EXPECT_TRUE(has(text_of(scene, "per-pixel/phong"), "gl_FragDepth"));
    scene = named("soft spot");
    scene.objects[0].mesh = PlaneShape{{1e5, 1e5}, 1};
    const std::string wide = text_of(scene, "per-pixel/phong");
    EXPECT_TRUE(has(wide, "ray_corner"));
    EXPECT_FALSE(has(wide, "v_position")); // in its place
    EXPECT_FALSE(has(text_of(scene, "per-vertex/phong"), "ray_corner"));
}

TEST(ProgramText, AnOrthographicCameraGivesOneVAndNoFault) {
    Scene scene = named("point");
    const std::string lambert = text_of(scene, "per-pixel/lambert");
    scene.camera.projection = Projection::orthographic;
    scene.camera.height = 3;
    for (const char *technique : {"per-pixel/phong", "per-vertex/blinn-phong", "interpolated-vectors/phong"}) {
        const std::string text = text_of(scene, technique);
        EXPECT_TRUE(has(text, "vec3 V = view_direction;")) << technique;
        EXPECT_FALSE(has(text, "Fault")) << technique;
        EXPECT_EQ(text, text_of(scene, std::string(technique) + ":viewer=infinite"));
    }
    EXPECT_EQ(text_of(scene, "per-pixel/lambert"), lambert) << "no V is read";
    scene.objects[0].mesh = PlaneShape{{1e6, 1e6}, 1};
    EXPECT_FALSE(has(text_of(scene, "per-pixel/phong"), "ray_corner"))
        << "rays from the eye are a perspective camera's";
}

TEST(ProgramText, AnOrdinarySceneIsTheTextbooksProgramToTheLetter) {
    for (const std::string &name : builtin_scenes(Assets("assets"))) {
        const Scene scene = open_scene(name, Assets("assets"));
        const auto resources = Resources(Assets("assets")).load(scene);
        for (const std::string technique :
             {"flat/phong", "per-vertex/phong", "per-pixel/phong", "per-pixel/blinn-phong",
              "interpolated-vectors/blinn-phong", "hybrid/phong"}) {
            const Features by_itself = prepare_objects(scene, parse_technique(technique), resources)[0].program;
            const Features textbook =
                prepare_objects(scene, parse_technique(technique + ":power=textbook"), resources)[0].program;
            EXPECT_EQ(by_itself, textbook) << name << ' ' << technique; // equal features give equal text
            EXPECT_EQ(assemble(by_itself, parts()).fragment.text, assemble(textbook, parts()).fragment.text);
            EXPECT_EQ(by_itself, without_guards(by_itself)) << name << ' ' << technique;
        }
    }
}

TEST(ProgramText, FrequenciesPutTheEquationWhereTheySay) {
    const Scene scene = named("point");
    const auto stages = [&](const std::string &technique) { return assemble(features_of(scene, technique), parts()); };
    EXPECT_TRUE(has(stages("per-vertex/phong").vertex.text, "vec3 point_light("));
    EXPECT_FALSE(has(stages("per-vertex/phong").fragment.text, "vec3 point_light("));
    EXPECT_TRUE(has(stages("flat/phong").vertex.text, "flat out vec3 v_light"));
    EXPECT_TRUE(has(stages("per-pixel/phong").fragment.text, "vec3 point_light("));
    EXPECT_FALSE(has(stages("hybrid/phong").vertex.text, "vec3 R"));
    EXPECT_FALSE(has(stages("hybrid/phong").fragment.text, "light.diffuse"));
    EXPECT_TRUE(has(stages("interpolated-vectors/phong").vertex.text, "out vec3 v_point_L[1]"));
    EXPECT_FALSE(has(stages("interpolated-vectors/phong").fragment.text, "v_position"));
}

TEST(ProgramText, TheSameLightingTextServesBothStages) {
    const Scene scene = named("all");
    const std::string vertex = assemble(features_of(scene, "per-vertex/blinn-phong"), parts()).vertex.text;
    const std::string fragment = assemble(features_of(scene, "per-pixel/blinn-phong"), parts()).fragment.text;
    const auto lighting = [](const std::string &text) {
        const auto from = text.find("struct DirectionalLight");
        const auto to = text.find("\n}\n", text.find("vec3 lighting("));
        return text.substr(from, to - from);
    };
    EXPECT_EQ(lighting(vertex), lighting(fragment));
}

TEST(ProgramText, InterpolatedVectorsRefusesWhatDoesNotFit) {
    Scene scene = named("point");
    scene.lights.assign(9, scene.lights[0]); // 9 (3 + 3) + 3 components
    const Technique technique = parse_technique("interpolated-vectors/blinn-phong");
    const Features nine = features_of(scene, to_string(technique));
    EXPECT_EQ(varying_components(nine), 57);
    EXPECT_NO_THROW(require_drawable(nine, scene.objects[0]));
    scene.lights.push_back(scene.lights[0]);
    EXPECT_THROW(require_drawable(features_of(scene, to_string(technique)), scene.objects[0]), InputError);
}

/// Two different keys for one text would compile it twice; one key for two texts cannot be (assemble is pure).
TEST(ProgramText, DifferentFeaturesGiveDifferentText) {
    for (const Scene &scene : feature_scenes()) {
        const Mesh mesh = build_mesh(scene.objects[0].mesh);
        std::map<std::string, Features> seen;
        for (const Technique &technique : pairwise_techniques()) {
            Features features = prepare_object(scene, technique, scene.objects[0], mesh).program;
            if (features.is_baked()) {
                continue; // what tells it from the specialised program is its constants
            }
            const ProgramSource source = assemble(features, parts());
            if (!features.specular()) { // power=naive stays though nothing is raised: a program more, and no other
                features.technique.power = Power::automatic;
            }
            const auto [found, is_new] = seen.emplace(source.vertex.text + source.fragment.text, features);
            EXPECT_TRUE(is_new || found->second == features) << scene.name << " " << to_string(technique);
        }
    }
}

} // namespace
} // namespace sandbox
