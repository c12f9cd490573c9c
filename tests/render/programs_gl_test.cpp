#include "image/error.h"
#include "render/gl_program.h"
#include "render/renderer.h"
#include "shading/prepared_object.h"
#include "tools/feature_scenes.h"
#include "tools/gl_test.h"
#include "tools/technique_walk.h"
#include "tools/temporary_folder.h"

#include <algorithm>
#include <regex>
#include <set>

namespace sandbox {
namespace {

class Programs : public GlTest {};

/// `uniform` declarations of a text: names without indices.
std::set<std::string> declared_uniforms(const std::string &text) {
    static const std::regex declaration(R"(uniform\s+\w+\s+(\w+))");
    std::set<std::string> names;
    for (std::sregex_iterator match(text.begin(), text.end(), declaration), end; match != end; ++match) {
        names.insert((*match)[1]);
    }
    return names;
}

/// Every text of the pairwise techniques over the feature scenes builds, and uses every uniform that it declares.
TEST_F(Programs, EverySpecialisedProgramBuildsAndLeavesNoUniformUnused) {
    const ShaderParts parts(Assets("shaders"));
    std::set<Features> built;
    for (const Scene &scene : feature_scenes()) {
        const Mesh mesh = build_mesh(scene.objects[0].mesh);
        for (const Technique &technique : pairwise_techniques()) {
            const Features features =
                prepare_object(scene, technique, scene.objects[0], mesh, {.object_ids = built.size() % 2 == 0}).program;
            if (!built.insert(features).second) {
                continue;
            }
            const ProgramSource source = assemble(features, parts);
            const GlProgram program(source);
            if (features.is_full()) {
                continue; // declares what some scene needs
            }
            std::set<std::string> active;
            for (const auto &[name, location] : program.uniforms()) {
                active.insert(name.substr(0, name.find_first_of(".[")));
            }
            std::set<std::string> declared = declared_uniforms(source.vertex.text);
            declared.merge(declared_uniforms(source.fragment.text));
            EXPECT_EQ(declared, active) << scene.name << " " << to_string(technique);
        }
    }
    EXPECT_GT(built.size(), 100U);
}

TEST_F(Programs, ATechniqueSeenBeforeBuildsNothing) {
    Renderer renderer(Assets("assets"), ShaderParts(Assets("shaders")));
    const Scene scene = feature_scenes()[1];
    Target target({32, 32});
    renderer.draw(scene, parse_technique("per-pixel/phong"), target);
    renderer.draw(scene, parse_technique("per-vertex/phong"), target);
    EXPECT_EQ(renderer.programs_built(), 2);
    renderer.draw(scene, parse_technique("per-pixel/phong"), target);
    EXPECT_EQ(renderer.programs_built(), 2);
}

/// A driver keeps megabytes for a program: a window that has been through every technique must not hold them all.
TEST_F(Programs, OfManyProgramsTheLastOnesUsedAreKept) {
    Renderer renderer(Assets("assets"), ShaderParts(Assets("shaders")));
    const Scene scene = feature_scenes()[1];
    Target target({8, 8});
    const std::vector<Technique> many = pairwise_techniques();
    const auto built_by = [&](const Technique &technique) {
        const int before = renderer.programs_built();
        renderer.draw(scene, technique, target);
        return renderer.programs_built() - before;
    };
    for (const Technique &technique : many) {
        built_by(technique);
    }
    EXPECT_EQ(built_by(many.back()), 0) << "just drawn";
    EXPECT_EQ(built_by(many.front()), 1) << "long ago";
    const std::shared_ptr<const void> kept = renderer.keep_all();
    for (const Technique &technique : many) {
        built_by(technique);
    }
    int again = 0;
    for (const Technique &technique : many) {
        again += built_by(technique);
    }
    EXPECT_EQ(again, 0) << "frames timed in turns would hold a compiler's time";
}

/// However many programs a frame needs, the next one finds them all.
TEST_F(Programs, WhatAFrameDrewItsNextOneFinds) {
    Renderer renderer(Assets("assets"), ShaderParts(Assets("shaders")));
    Scene scene = feature_scenes()[1];
    const Object object = scene.objects.front();
    for (int i = 1; i < 60; ++i) { // baked: a program an object
        scene.objects.push_back(object);
        scene.objects.back().material.shininess = 100 + i;
    }
    Target target({8, 8});
    const Technique baked = parse_technique("per-pixel/phong:program=baked");
    renderer.draw(scene, baked, target);
    const int built = renderer.programs_built();
    EXPECT_GE(built, 60);
    renderer.draw(scene, baked, target);
    EXPECT_EQ(renderer.programs_built(), built);
}

TEST_F(Programs, AChangedPartIsReloadedAndAnErrorKeepsTheLastGoodProgram) {
    const TemporaryFolder folder;
    const Assets built_in("shaders");
    for (const auto &name : built_in.list("")) {
        folder.write(name, built_in.read(name).value());
    }
    Renderer renderer(Assets("assets"), ShaderParts(Assets("shaders", folder.path())));
    const Scene scene = feature_scenes()[1];
    const auto middle = [&] {
        return renderer.render(scene, parse_technique("per-pixel/lambert"), {9, 9}).color.at(4, 4);
    };
    const glm::vec4 before = middle();
    ASSERT_GT(before.g, 0);
    EXPECT_FALSE(renderer.reload_changed_parts());

    const std::string good = built_in.read("light_terms.glsl").value();
    folder.write("light_terms.glsl", good + "    no such thing;\n");
    EXPECT_TRUE(renderer.reload_changed_parts());
    EXPECT_EQ(middle(), before);
    const auto line = std::count(good.begin(), good.end(), '\n') + 1;
    EXPECT_NE(renderer.shader_error().find("light_terms.glsl:" + std::to_string(line)), std::string::npos)
        << renderer.shader_error();
    renderer.forget_last_good_programs(); // for whoever measures what is on disk, or nothing
    EXPECT_THROW(middle(), ShaderError);

    std::string doubled = good;
    doubled.replace(doubled.find("return ${light.sum}"), 19, "return 2.0 * (${light.sum})");
    folder.write("light_terms.glsl", doubled);
    EXPECT_TRUE(renderer.reload_changed_parts());
    EXPECT_FLOAT_EQ(middle().g, 2 * before.g);
    EXPECT_TRUE(renderer.shader_error().empty());
}

TEST_F(Programs, AProgramThatNeverBuiltIsAnErrorThatNamesPartAndLine) {
    const TemporaryFolder folder;
    const Assets built_in("shaders");
    for (const auto &name : built_in.list("")) {
        folder.write(name, built_in.read(name).value());
    }
    folder.write("reflection_phong.glsl", "float phong(vec3 R, vec3 L)\n{\n    return R;\n}\n");
    Renderer renderer(Assets("assets"), ShaderParts(Assets("shaders", folder.path())));
    try {
        renderer.render(feature_scenes()[1], parse_technique("per-pixel/phong"), {8, 8});
        FAIL() << "no error";
    } catch (const ShaderError &error) {
        EXPECT_NE(std::string(error.what()).find("reflection_phong.glsl:3"), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace sandbox
