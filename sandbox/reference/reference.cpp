#include "reference/reference.h"

#include "image/error.h"
#include "reference/analytic_picture.h"
#include "reference/mesh_picture.h"

#include <chrono>
#include <stdexcept>

namespace sandbox {

namespace {

std::unique_ptr<reference::Picture> picture_of(const Scene &scene, const std::vector<ObjectResources> &resources,
                                               const Technique &technique, Size size, Surface surface,
                                               const reference::HighValues &high = {}) {
    if (size.width <= 0 || size.height <= 0 || resources.size() != scene.objects.size()) {
        throw std::invalid_argument("reference: a size above 0 and one resource an object are needed");
    }
    if (technique.model == Model::own) {
        throw InputError("own shading has no reference: name the model that it is held against, as in "
                         "reference:model=phong");
    }
    return surface == Surface::mesh ? reference::mesh_picture(scene, resources, technique, size, high)
                                    : reference::analytic_picture(scene, resources, technique, size);
}

ReferenceFrame background(const Scene &scene, Size size) {
    ReferenceFrame frame;
    frame.size = size;
    frame.color.assign(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), scene.background);
    return frame;
}

} // namespace

ReferenceFrame render_reference(const Scene &scene, const std::vector<ObjectResources> &resources,
                                const Technique &technique, Size size, Surface surface, const Progress &progress) {
    const auto start = std::chrono::steady_clock::now();
    const auto picture = picture_of(scene, resources, technique, size, surface);
    ReferenceFrame frame = background(scene, size);
    const std::size_t pixels = frame.color.size();
    frame.object_ids.assign(pixels, 0);
    frame.edge.assign(pixels, 0);
    frame.rival.assign(pixels, 0);
    frame.jump.assign(pixels, 0);
    frame.rounding.assign(pixels, 0);
    parallel_for(
        picture->bands(), [&](std::size_t band) { picture->draw(band, frame); }, progress);
    frame.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return frame;
}

Frame to_frame(const ReferenceFrame &frame) {
    Frame out;
    out.color = Image(frame.size);
    for (std::size_t i = 0; i < frame.color.size(); ++i) {
        out.color.pixels[i] = glm::vec4(glm::vec3(frame.color[i]), 1);
    }
    out.object_ids = frame.object_ids;
    out.milliseconds = frame.milliseconds;
    return out;
}

Image reference_colors(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &technique,
                       Size size, const reference::HighValues &high) {
    const auto picture = picture_of(scene, resources, technique, size, Surface::mesh, high);
    ReferenceFrame frame = background(scene, size);
    parallel_for(picture->bands(), [&](std::size_t band) { picture->draw(band, frame); });
    return to_frame(frame).color;
}

std::optional<PixelProbe> probe_pixel(const Scene &scene, const std::vector<ObjectResources> &resources,
                                      const Technique &technique, Size size, int x, int y, Surface surface) {
    const auto picture = picture_of(scene, resources, technique, size, surface);
    if (x < 0 || y < 0 || x >= size.width || y >= size.height) {
        return {};
    }
    return picture->probe(x, y);
}

std::vector<std::optional<glm::dvec3>> reference_row(const Scene &scene, const std::vector<ObjectResources> &resources,
                                                     const Technique &technique, Size size, int y, Surface surface) {
    return picture_of(scene, resources, technique, size, surface)->row(y);
}

} // namespace sandbox
