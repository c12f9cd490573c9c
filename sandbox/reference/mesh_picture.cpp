#include "reference/mesh_picture.h"

#include "reference/fragment.h"
#include "shading/eye_space.h"

#include <algorithm>
#include <glm/common.hpp>

namespace sandbox::reference {

namespace {

class MeshPicture : public Picture {
  public:
    MeshPicture(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &technique,
                Size size, const HighValues &high)
        : size_(size), meshes_(prepare_meshes(scene, resources, technique, size, high)),
          rasteriser_(meshes_.raster, size, DepthRange(scene.camera, is_deep(scene, resources))) {}

    [[nodiscard]] std::size_t bands() const override { return rasteriser_.bands(); }

    void draw(std::size_t band, ReferenceFrame &frame) const override {
        const std::vector<Hit> hits = rasteriser_.draw(band);
        const int width = size_.width;
        const auto first = static_cast<std::size_t>(rasteriser_.first_row(band)) * static_cast<std::size_t>(width);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            const int x = static_cast<int>(i) % width;
            const int y = rasteriser_.first_row(band) + static_cast<int>(i) / width;
            shade(hits[i], x, y, first + i, frame);
        }
    }

    [[nodiscard]] std::optional<PixelProbe> probe(int x, int y) const override {
        const std::size_t band = rasteriser_.band_of(y);
        const std::vector<Hit> hits = rasteriser_.draw(band);
        const Hit &hit =
            hits[static_cast<std::size_t>(y - rasteriser_.first_row(band)) * static_cast<std::size_t>(size_.width) +
                 static_cast<std::size_t>(x)];
        if (hit.object == 0) {
            return {};
        }
        const Fragment fragment(meshes_, hit, x + 0.5, y + 0.5);
        const SurfacePoint point = fragment.evaluated_point();
        const PixelMasks masks = fragment.masks();
        return PixelProbe{.object = hit.object - 1,
                          .triangle = hit.triangle,
                          .position = point.position + meshes_.setup.eye,
                          .normal = point.normal,
                          .view = point.view,
                          .base = fragment.base(),
                          .lights = fragment.probe_lights(point),
                          .color = fragment.color(),
                          .edge = on_edge(hit, fragment),
                          .jump = masks.jump,
                          .rounding = masks.rounding,
                          .doubt = masks.doubt,
                          .window_rounding = window_rounding(hit, x, y, fragment.color())};
    }

    [[nodiscard]] std::vector<std::optional<glm::dvec3>> row(int y) const override {
        const std::size_t band = rasteriser_.band_of(y);
        const std::vector<Hit> hits = rasteriser_.draw(band);
        const auto width = static_cast<std::size_t>(size_.width);
        const std::size_t first = static_cast<std::size_t>(y - rasteriser_.first_row(band)) * width;
        std::vector<std::optional<glm::dvec3>> colors(width);
        for (std::size_t x = 0; x < width; ++x) {
            if (const Hit &hit = hits[first + x]; hit.object != 0) {
                colors[x] = Fragment(meshes_, hit, static_cast<double>(x) + 0.5, y + 0.5).color();
            }
        }
        return colors;
    }

  private:
    /// A neighbour that just misses the centre counts if it would be seen there, within the depth buffer's resolution.
    [[nodiscard]] bool on_edge(const Hit &hit, const Fragment &fragment) const {
        return hit.tie || rasteriser_.beside_wins(hit) || fragment.at_edge();
    }

    /// A window coordinate is rounded four times, each time by up to 2^-24 of the longer side: by the transform, the
    /// division, the viewport and the interpolation.
    [[nodiscard]] double window_rounding(const Hit &hit, int x, int y, const glm::dvec3 &color) const {
        const double shift = 0x1p-22 * std::max(size_.width, size_.height);
        const glm::dvec3 moved = glm::abs(Fragment(meshes_, hit, x + 0.5 + shift, y + 0.5).color() - color) +
                                 glm::abs(Fragment(meshes_, hit, x + 0.5, y + 0.5 + shift).color() - color);
        return std::max({moved.x, moved.y, moved.z});
    }

    void shade(const Hit &hit, int x, int y, std::size_t pixel, ReferenceFrame &frame) const {
        const bool masks = !frame.edge.empty();
        if (hit.object == 0) {
            if (masks) {
                frame.edge[pixel] = hit.beside > 0 ? 1 : 0;
            }
            return;
        }
        const Fragment fragment(meshes_, hit, x + 0.5, y + 0.5);
        frame.color[pixel] = fragment.color();
        if (!masks) {
            return;
        }
        frame.object_ids[pixel] = hit.object;
        const bool own = rasteriser_.beside_wins(hit) || hit.own_tie || fragment.at_edge();
        frame.edge[pixel] = own || hit.tie ? 1 : 0;
        frame.rival[pixel] = hit.tie && !own ? 1 : 0;
        frame.mark(pixel, fragment.masks());
    }

    Size size_;
    MeshScene meshes_;
    Rasteriser rasteriser_;
};

} // namespace

std::unique_ptr<Picture> mesh_picture(const Scene &scene, const std::vector<ObjectResources> &resources,
                                      const Technique &technique, Size size, const HighValues &high) {
    return std::make_unique<MeshPicture>(scene, resources, technique, size, high);
}

} // namespace sandbox::reference
