#include "commands/commands.h"

#include "commands/own_flags.h"
#include "scene/resources.h"
#include "scene/scene_file.h"
#include "shading/prepared_object.h"
#include "shading/program_source.h"

#include <fmt/format.h>

namespace sandbox {
namespace {

struct GlslFlags {
    std::string scene, stage, object, technique;
    OwnFlags own;
};

std::string indexed_name(std::size_t object) { return fmt::format("objects[{}]", object); }

/// How an object is named on the command line: its name, or its index where it has none.
std::string object_name(const Scene &scene, std::size_t i) {
    return scene.objects[i].name.empty() ? indexed_name(i) : scene.objects[i].name;
}

std::size_t find_object(const Scene &scene, const std::string &name) {
    if (scene.objects.empty()) {
        throw InputError("the scene has no object, so it needs no program");
    }
    std::vector<std::string> names;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        names.push_back(object_name(scene, i));
        if (name.empty() || name == names.back() || name == indexed_name(i)) {
            return i;
        }
    }
    throw InputError("--object: there is no '{}'; the scene has {}", name, fmt::join(names, ", "));
}

/// Says which objects need another program than the one that is printed.
void note_other_programs(const Scene &scene, const std::vector<PreparedObject> &objects, std::size_t printed) {
    std::vector<std::string> others;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (objects[i].program != objects[printed].program) {
            others.push_back(object_name(scene, i));
        }
    }
    if (!others.empty()) {
        note(fmt::format("this is the program of {}; --object prints that of {}", object_name(scene, printed),
                         fmt::join(others, ", ")));
    }
}

int run_glsl(const GlslFlags &flags, const CommonOptions &common) {
    OwnTechniques techniques(flags.own);
    const Technique technique = techniques.single("--technique", flags.technique);
    techniques.require_all_used();
    const Scene scene = open_scene(common, flags.scene);
    const std::size_t chosen = find_object(scene, flags.object);
    const std::vector<ObjectResources> resources = Resources(scene_assets(common)).load(scene);
    const std::vector<PreparedObject> objects = prepare_objects(scene, technique, resources);
    require_drawable(objects[chosen].features, scene.objects[chosen]);
    ProgramSource program = assemble(objects[chosen].program, ShaderParts(shader_assets(common)));
    if (common.profile == Profile::es) {
        program = {in_es(std::move(program.vertex)), in_es(std::move(program.fragment))};
    }
    note_other_programs(scene, objects, chosen);
    note_no_effect(scene, technique);
    if (technique.frequency == Frequency::automatic) {
        note("this is what is lit per pixel by every light; the rest has the program of " +
             to_string(part_of_auto(technique, Frequency::per_vertex)));
    }
    if (flags.stage.empty()) {
        print(fmt::format("// ---- vertex stage ----\n{}\n// ---- fragment stage ----\n{}", program.vertex.text,
                          program.fragment.text));
    } else {
        print(flags.stage == "vertex" ? program.vertex.text : program.fragment.text);
    }
    return 0;
}

} // namespace

void add_glsl_options(CLI::App &command, CommonOptions &common, Run &run) {
    const auto flags = std::make_shared<GlslFlags>();
    add_scene(command, flags->scene);
    add_value(command, "--technique", "T", flags->technique,
              "Technique; with program=full, the program that can draw every scene")
        ->required();
    add_own_files(command, flags->own, false);
    add_choice(command, "--stage", {"vertex", "fragment"}, flags->stage, "Print only this stage");
    add_value(command, "--object", "NAME", flags->object, "Object whose program to print [the first]");
    command.footer("Needs no OpenGL.");
    run_when_chosen(command, common, run, flags, run_glsl);
}

} // namespace sandbox
