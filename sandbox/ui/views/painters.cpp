#include "ui/views/painters.h"

#include "measure/stability/textbook.h"
#include "reference/reference.h"
#include "render/target.h"

#include <utility>

namespace sandbox {

Painters painters_of(Renderer &renderer, const Overlays &overlays) {
    const auto resources = [&renderer](const Scene &scene) { return renderer.resources().load(scene); };
    const DrawView textbook = [resources](const Scene &scene, const Technique &technique, Size size) {
        return textbook_picture(scene, resources(scene), technique, size).color;
    };
    // Lines over what `picture` draws, hidden by the depth that the renderer draws.
    const auto with_lines = [&renderer, overlays](const DrawView &picture) {
        return [&renderer, overlays, picture](const Scene &scene, const Technique &technique, Size size) {
            Target target(size);
            renderer.draw(scene, technique, target);
            if (picture) {
                target.write_color(picture(scene, technique, size));
            }
            renderer.draw_overlays(scene, technique, overlays, target);
            return target.read_color();
        };
    };
    const DrawView draw = [&renderer](const Scene &scene, const Technique &technique, Size size) {
        return renderer.render(scene, technique, size).color;
    };
    const bool lines = overlays != Overlays{};
    return {.draw = lines ? DrawView(with_lines({})) : draw,
            .textbook = lines ? DrawView(with_lines(textbook)) : textbook,
            .truth =
                [resources](const Scene &scene, const Technique &technique, Size size) {
                    return to_frame(render_reference(scene, resources(scene), technique, size)).color;
                },
            .probe = [resources](const Scene &scene, const Technique &technique, Size size, int x,
                                 int y) { return probe_pixel(scene, resources(scene), technique, size, x, y); },
            .judge =
                [resources, &renderer](const Scene &scene, const Technique &technique, const Technique &truth,
                                       Size size, bool of_textbook) {
                    const auto loaded = resources(scene);
                    const Frame drawn = of_textbook ? textbook_picture(scene, loaded, technique, size)
                                                    : renderer.render(scene, technique, size, true);
                    return judge_view(drawn, render_reference(scene, loaded, truth, size));
                }};
}

} // namespace sandbox
