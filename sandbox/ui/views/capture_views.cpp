#include "ui/views/capture_views.h"

#include "image/image_file.h"
#include "measure/stability/stability.h"
#include "ui/session/capture_files.h"

namespace sandbox {

std::filesystem::path capture_views(const Session &session, ViewPainter &painter, const DrawnBy &by) {
    const Size each = painter.view(false).size;
    const Scene scene = scene_in_view(session.document, each); // so that the sidecar alone gives the same picture
    const PictureOptions options = picture_options(session, each);
    Renderer &renderer = painter.renderer();
    const Image linear = draw_picture(
        scene, options,
        [&](const Scene &s, const Technique &technique, Size size) {
            return renderer.render(s, technique, size).color;
        },
        [&](const Scene &s, const Technique &technique, Size size) {
            return textbook_picture(s, renderer.resources().load(s), technique, size).color;
        });
    std::filesystem::path path = free_name(capture_folder(), session.document.opened->name);
    write_file(path, encode_png(show_picture(linear, options)));
    write_file(sidecar_path(path), sidecar_text(scene, options, by));
    return path;
}

} // namespace sandbox
