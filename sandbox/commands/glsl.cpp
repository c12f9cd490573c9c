#include "commands/commands.h"

#include "scene/resources.h"
#include "scene/scene_file.h"
#include "shading/program_source.h"

#include <algorithm>
#include <memory>

namespace sandbox {
namespace {

struct GlslFlags {
    std::string scene, technique, stage, object;
};

/// How an object is named on the command line: its name, or its place where it has none.
std::string object_name(const Scene &scene, std::size_t i) {
    const std::string &name = scene.objects[i].name;
    return name.empty() ? "objects[" + std::to_string(i) + "]" : name;
}

std::string object_names(const Scene &scene) {
    std::string names;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        names += (i == 0 ? "" : ", ") + object_name(scene, i);
    }
    return names;
}

std::size_t chosen_object(const Scene &scene, const std::string &name) {
    if (scene.objects.empty()) {
        throw InputError("the scene has no object, so it needs no program");
    }
    if (name.empty()) {
        return 0;
    }
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (object_name(scene, i) == name || "objects[" + std::to_string(i) + "]" == name) {
            return i;
        }
    }
    throw InputError("--object: there is no '" + name + "'; the scene has " + object_names(scene));
}

/// Says which objects need another program than the one that is printed.
void note_other_programs(const Scene &scene, const std::vector<Features> &features, std::size_t chosen) {
    std::string others;
    for (std::size_t i = 0; i < features.size(); ++i) {
        if (features[i] != features[chosen]) {
            others += (others.empty() ? "" : ", ") + object_name(scene, i);
        }
    }
    if (!others.empty()) {
        note("this is the program of " + object_name(scene, chosen) + "; --object prints the others': " + others);
    }
}

int run_glsl(const GlslFlags &flags, const CommonOptions &common) {
    const Technique technique = with_flag("--technique", [&] { return parse_technique(flags.technique); });
    const Scene scene = open_scene(common, flags.scene);
    const std::size_t chosen = chosen_object(scene, flags.object);
    const std::vector<ObjectResources> resources = Resources(scene_assets(common)).load(scene);
    const std::vector<Features> features = derive_features(scene, technique, resources);
    require_drawable(features[chosen], scene, technique, scene.objects[chosen]);
    const ProgramSource program = assemble(features[chosen], ShaderParts(shader_assets(common)));
    note_other_programs(scene, features, chosen);
    if (flags.stage.empty()) {
        print("// ---- vertex stage ----\n" + program.vertex.text + "\n// ---- fragment stage ----\n" +
              program.fragment.text);
    } else {
        print(flags.stage == "vertex" ? program.vertex.text : program.fragment.text);
    }
    return 0;
}

} // namespace

void add_glsl(CLI::App &app, CommonOptions &common, Run &run) {
    CLI::App *command = app.add_subcommand("glsl", "Print the program of a scene under a technique");
    auto flags = std::make_shared<GlslFlags>();
    command->add_option("SCENE", flags->scene, "Built-in name, .json or .obj")->type_name("")->required();
    command->add_option("--technique", flags->technique, "program=full in it: the program that can do every scene")
        ->type_name("T")
        ->required();
    command->add_option("--stage", flags->stage, "Only this stage")
        ->type_name("vertex|fragment")
        ->check(CLI::IsMember({"vertex", "fragment"}).description(""));
    command->add_option("--object", flags->object, "Whose program, where objects need different ones [the first]")
        ->type_name("NAME");
    command->footer("Needs no OpenGL.");
    add_common_options(*command, common);
    command->callback([flags, &common, &run] { run = [flags, &common] { return run_glsl(*flags, common); }; });
}

} // namespace sandbox
