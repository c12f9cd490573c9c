#include "commands/commands.h"

#include "image/file_io.h"
#include "image/image_file.h"
#include "shading/own_files.h"

namespace sandbox {
namespace {

struct OwnCommandFlags {
    std::string scene;
    std::filesystem::path out;
    Technique technique;
    bool starter = false;
    bool answer = false;
};

/// An answer is right and has no keys; its text is the same under the three frequencies that take it.
void refuse_other_techniques(const Technique &technique) {
    const bool taken = technique.frequency == Frequency::flat || technique.frequency == Frequency::per_vertex ||
                       technique.frequency == Frequency::per_pixel;
    if (!taken || technique != Technique{.frequency = technique.frequency, .model = technique.model}) {
        throw InputError("--technique: expected flat, per-vertex or per-pixel with a model and no keys, got {}",
                         to_string(technique));
    }
}

int run_own(const OwnCommandFlags &flags, const CommonOptions &common) {
    if (flags.starter == flags.answer) {
        throw InputError("own: expected either --starter or --answer");
    }
    if (!flags.out.empty()) {
        check_output(flags.out, {".glsl"});
    }
    refuse_other_techniques(flags.technique);
    std::optional<Scene> scene;
    if (flags.scene.empty()) {
        refuse_settings(common, "own changes a SCENE, and none is given");
    } else {
        scene = open_scene(common, flags.scene);
    }
    const OwnReader reader{scene ? &*scene : nullptr, scene ? flags.scene : "SCENE"};
    const ShaderParts parts(shader_assets(common));
    const std::string text =
        flags.starter ? own_starter(reader, flags.technique, parts) : own_answer(reader, flags.technique, parts);
    if (flags.out.empty()) {
        print(text);
    } else {
        write_file(flags.out, text);
    }
    return 0;
}

} // namespace

void add_own_options(CLI::App &command, CommonOptions &common, Run &run) {
    const auto flags = std::make_shared<OwnCommandFlags>();
    add_value(command, "SCENE", "", flags->scene, "Built-in name or path: write only what this scene needs");
    command.add_flag("--starter", flags->starter, "A file to begin with: the interface as comments, and an empty body");
    command.add_flag("--answer", flags->answer, "The textbook's file");
    add_parsed(command, "--technique", "T", flags->technique, parse_technique,
               "The model that is asked for, and where it is evaluated [per-pixel/blinn-phong]");
    add_value(command, "--out", "FILE.glsl", flags->out, "Write it to this file");
    command.footer(
        "Own shading is GLSL ES 3.00 that defines vec3 lighting(vec3 P, vec3 N, vec3 eye). It is drawn as the "
        "model\nown: --technique per-pixel/own --own FILE.glsl. Needs no OpenGL.");
    run_when_chosen(command, common, run, flags, run_own);
}

} // namespace sandbox
