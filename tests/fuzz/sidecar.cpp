#include "capture/sidecar.h"

#include "capture/frame_names.h"
#include "capture/grid.h"
#include "fuzz/target.h"
#include "fuzz/targets.h"
#include "scene/motion.h"
#include "scene/scene_file.h"

#include <cmath>

namespace sandbox {
namespace {

const DrawnBy nobody{"a renderer", "3.3"};

/// `write` makes a sidecar with what `read` has read; it reads back as it was.
template <class Read, class Write> void held_round(std::string_view bytes, Read read, Write write) {
    if (const auto found = accepted([&] { return read(bytes, "a.json"); }); found && *found) {
        const std::string written = write(**found);
        held(read(written, "again.json") == *found, "reads back as it was: " + written);
    }
}

/// What a sidecar keeps: one view alone has no other technique, and only a difference and a wipe have their own keys.
PictureOptions kept(PictureOptions options) {
    const PictureOptions defaults;
    if (options.layout == Layout::single && options.flip == FlipSide::none) {
        options.right = options.left;
    }
    options.difference_of = options.layout == Layout::difference ? options.difference_of : defaults.difference_of;
    options.divider = options.layout == Layout::wipe ? options.divider : defaults.divider;
    return options;
}

void held_options(const Scene &scene, const PictureOptions &options) {
    held(std::isfinite(options.exposure) && options.exposure >= 0 && std::isfinite(options.gain) && options.gain > 0,
         "exposure and gain are numbers");
    const std::string written = sidecar_text(scene, options, nobody);
    held(sidecar_options(written, "again.json") == kept(options), "reads back as it was: " + written);
    held(parse_scene(written, "again.json", "/nowhere") == scene, "its scene reads back as it was: " + written);
}

} // namespace

void check_sidecar(std::string_view bytes) {
    const auto scene = accepted([&] { return parse_scene(bytes, "a.json", "/nowhere"); });
    const auto options = accepted([&] { return sidecar_options(bytes, "a.json"); });
    if (scene && options && *options) {
        held_options(*scene, **options);
    }
    static const std::string plain = sidecar_text({}, {}, nobody);
    const auto has = [&](std::string_view key) { return bytes.find(key) != std::string_view::npos; };
    if (has("\"frames\"") || has("\"orbit_degrees\"")) {
        held_round(bytes, turntable_of, [](const Turntable &table) { return turntable_text(plain, table); });
    }
    if (has("\"rows\"") || has("\"sweep\"")) {
        held_round(
            bytes, [](std::string_view text, std::string_view name) { return grid_of(text, name); },
            [](const Grid &grid) { return grid_text(plain, grid); });
    }
    if (!has("\"motion\"")) {
        return;
    }
    held_round(bytes, motion_of, [](const Motion &motion) { return motion_sidecar(plain, motion); });
    const auto motion = accepted([&] { return motion_of(bytes, "a.json"); });
    if (scene && motion && *motion) {
        held(moments_of(**motion) >= 2, "a motion has two moments");
        accepted([&] { return moved(*scene, **motion, 7); });
        accepted([&] { return sweep_of(**motion, *scene, 5); });
    }
}

std::vector<std::string> sidecar_seeds() {
    const Scene scene = open_scene("box-5-specular", Assets("assets"));
    PictureOptions wipe;
    wipe.layout = Layout::wipe;
    wipe.divider = 0.25;
    wipe.left = parse_technique("per-vertex/phong");
    wipe.right = parse_technique("per-pixel/blinn-phong:gate=none");
    wipe.mesh_factors = {0.5, 1};
    wipe.language = "zh";
    wipe.labels = true;
    PictureOptions marked;
    marked.marks = {glm::dvec2(0.5, 0.25), true, true, 0.75, glm::dvec3(0.5, 0.5, 0.1)};
    marked.display = Display::srgb;
    marked.exposure = 2;
    marked.view = "front";
    marked.samples = 16;
    PictureOptions difference;
    difference.layout = Layout::difference;
    difference.difference_of = DifferenceOf::a_truth;
    difference.gain = 10;
    difference.textbook_left = true;
    PictureOptions flipped;
    flipped.flip = FlipSide::b;
    flipped.masks = true;
    const std::string single = sidecar_text({}, {}, nobody);
    const Motion orbit{};
    const Motion number{Mover::number, 0, "lights[0].diffuse", 0, 1, 4, Course::to_and_fro};
    return {single,
            sidecar_text(scene, {}, nobody),
            sidecar_text({}, wipe, nobody),
            sidecar_text({}, marked, nobody),
            sidecar_text({}, difference, nobody),
            sidecar_text({}, flipped, nobody),
            turntable_text(single, {36, 360}),
            motion_sidecar(single, orbit),
            motion_sidecar(single, number),
            grid_text(single, {{wipe.left, wipe.right}, parse_sweep("objects[0].material.shininess=1,10,100")}),
            with_keys(single, R"({"techniques":[{"technique":"per-pixel/own","file":"a.glsl",)"
                              R"("own":"vec3 lighting(vec3 P, vec3 N, vec3 eye) { return vec3(1); }"}]})")};
}

} // namespace sandbox
