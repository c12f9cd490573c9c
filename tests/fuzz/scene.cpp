#include "capture/opening_view.h"
#include "fuzz/target.h"
#include "fuzz/targets.h"
#include "scene/motion.h"
#include "scene/read_json.h"
#include "scene/scene_file.h"
#include "scene/scene_setting.h"

#include <cmath>
#include <limits>

namespace sandbox {
namespace {

void held_scene(const Scene &scene) {
    const std::string text = scene_text(scene);
    held(parse_scene(text, "again.json", "/nowhere") == scene, "a scene reads back as it was: " + text);
    for (const SceneNumber &number : numbers_of(scene)) {
        const Range &range = number.range;
        held(std::isfinite(number.value) &&
                 (number.value == range.or_exactly || (number.value >= range.low && number.value <= range.high)),
             number.path + " is within its range");
    }
    accepted([&] { return opening_view(scene, "a.json").layout; });
}

} // namespace

/// A scene file; or, of bytes that begin no object, a PATH=VALUE as --set takes it.
void check_scene(std::string_view bytes) {
    if (begins_object(bytes)) {
        if (const auto scene = accepted([&] { return parse_scene(bytes, "a.json", "/nowhere"); })) {
            held_scene(*scene);
        }
        return;
    }
    static const Scene studio = open_scene("studio", Assets("assets"));
    if (const auto scene = accepted([&] { return with_setting(studio, bytes); })) {
        held_scene(*scene);
    }
}

std::vector<std::string> scene_seeds() {
    std::vector<std::string> seeds = files_in("assets/scenes", ".json");
    for (const char *folder : {"assets/stability/scenes", "tests/data/lighting"}) {
        for (std::string &file : files_in(folder, ".json")) {
            seeds.push_back(std::move(file));
        }
    }
    seeds.insert(seeds.end(), {"lights[0].diffuse=0.5", "name=studio", "objects[0].material.texture=wood.png",
                               R"(camera={"position":[1,2,3],"projection":"orthographic","height":2})",
                               "objects[0].mesh.obj=a.obj", "lights=[]"});
    return seeds;
}

} // namespace sandbox
