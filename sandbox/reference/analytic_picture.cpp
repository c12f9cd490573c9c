#include "reference/analytic_picture.h"

#include "image/error.h"
#include "reference/analytic.h"
#include "reference/medium_stage.h"
#include "reference/raster.h"
#include "reference/surface.h"
#include "scene/space.h"
#include "shading/eye_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace sandbox::reference {

namespace {

constexpr int band_rows = 16;

struct AnalyticObject {
    const Object *object = nullptr;
    Setup setup; ///< the scene's, with the origin that OpenGL measures this object's positions from
    WorldTransform to_world;
    glm::dmat3 inverse{1};
    BaseColor base;
};

/// What a ray through a point of the picture sees.
struct Seen {
    std::uint32_t object = 0; ///< 0 background, i + 1 objects[i]
    ShapeHit hit;
};

/// Another object or another face: an outline or a crease runs between the two.
bool differs(const Seen &a, const Seen &b) { return a.object != b.object || a.hit.part != b.hit.part; }

/// Positions from the eye.
struct Ray {
    glm::dvec3 origin, direction;
};

/// Rays through the picture, scaled so that t is the distance along the camera's axis.
struct Eye {
    CameraAxes axes;
    bool orthographic;
    double half_height; ///< of what is seen: at a distance of 1 or, if orthographic, at every distance
    Size size;
    double near, far;

    Eye(const Camera &camera, Size s)
        : axes(camera_axes(camera)), orthographic(is_orthographic(camera)),
          half_height(orthographic ? camera.height / 2 : std::tan(camera.fov_y_degrees * std::acos(-1.0) / 360)),
          size(s), near(camera.near_plane), far(camera.far_plane) {}
    [[nodiscard]] Ray ray(double x, double y) const {
        const double half_width = half_height * size.width / size.height;
        const glm::dvec3 across = axes.right * ((2 * x / size.width - 1) * half_width);
        const glm::dvec3 up = axes.up * ((1 - 2 * y / size.height) * half_height);
        return orthographic ? Ray{across + up, axes.forward} : Ray{glm::dvec3(0), axes.forward + across + up};
    }
};

std::optional<ShapeHit> hit_object(const AnalyticObject &object, const Eye &eye, const Ray &ray) {
    return intersect(object.object->mesh, object.inverse * (ray.origin - object.to_world.offset),
                     object.inverse * ray.direction, eye.near, eye.far);
}

/// One shape around a pixel's centre.
class ShapeSampler : public Sampler {
  public:
    ShapeSampler(const AnalyticObject &shape, const Eye &eye, const ShapeHit &hit, double x, double y)
        : Sampler(shape.setup, *shape.object), shape_(shape), eye_(eye), hit_(hit), x_(x), y_(y) {}

    [[nodiscard]] ShapeHit hit_at(double dx, double dy) const {
        const auto hit = dx == 0 && dy == 0 ? hit_ : hit_object(shape_, eye_, eye_.ray(x_ + dx, y_ + dy));
        return hit && hit->part == hit_.part ? *hit : hit_;
    }

    [[nodiscard]] SurfacePoint point_at(double dx, double dy) const override {
        const ShapeHit hit = hit_at(dx, dy);
        return surface_point(shape_.to_world.lit(hit.position), shape_.to_world.normal(hit.normal),
                             hit.back ? Side::back : Side::front);
    }

    [[nodiscard]] glm::dvec3 base() const {
        return shape_.base.color_at(hit_.uv * object_.material.texture_repeat, hit_.position);
    }

    [[nodiscard]] glm::dvec3 color() const {
        const SurfacePoint here = point_at(0, 0);
        if (setup_.technique.precision == Precision::medium) {
            return medium_color(setup_, object_, shape_.base,
                                {.position = here.position - setup_.origin,
                                 .normal = here.raw_normal,
                                 .uv = hit_.uv * object_.material.texture_repeat,
                                 .object_position = hit_.position,
                                 .side = hit_.back ? Side::back : Side::front});
        }
        const Reflected reflected = reflect(Terms::all, here);
        return compose(object_.material, base(), reflected);
    }

    [[nodiscard]] PixelMasks masks() const {
        const SurfacePoint here = point_at(0, 0);
        const Doubts doubts = Sampler::doubts(Terms::all, here);
        const bool border =
            shape_.base.has_cells() && shape_.base.cell_may_change(hit_.position, hit_at(edge_width, 0).position,
                                                                   hit_at(0, edge_width).position, glm::dvec3(0));
        return border ? border_masks(doubts, *shape_.base.checker, reflect(Terms::all, here))
                      : Sampler::masks(doubts, base());
    }

  private:
    const AnalyticObject &shape_;
    const Eye &eye_;
    const ShapeHit &hit_;
    double x_, y_;
};

AnalyticObject prepare_object(const Setup &setup, const Scene &scene, const Object &object,
                              const ObjectResources &resources) {
    if (const auto *obj = std::get_if<ObjShape>(&object.mesh)) {
        throw InputError("{} is the mesh {}, which has no analytic surface", object.name, obj->path);
    }
    AnalyticObject prepared{&object, setup, world_transform(object.transform, setup), glm::dmat3(1),
                            base_color(object, resources)};
    prepared.setup.origin = eye_space(scene, object, *resources.mesh, setup.technique).lit_origin - setup.eye;
    const glm::dvec3 &scale = object.transform.scale;
    if (scale.x == 0 || scale.y == 0 || scale.z == 0) {
        throw InputError("{} is flattened by a scale of 0 and has no analytic surface", object.name);
    }
    // (R S)^-1 = S^-1 R^T: exact under any scale.
    Transform rotation = object.transform;
    rotation.scale = glm::dvec3(1);
    prepared.inverse = glm::transpose(linear_part(rotation));
    for (int axis = 0; axis < 3; ++axis) {
        prepared.inverse[axis] /= scale;
    }
    return prepared;
}

class AnalyticPicture : public Picture {
  public:
    AnalyticPicture(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &technique,
                    Size size)
        : size_(size), setup_(prepare(scene, technique)), eye_(scene.camera, size) {
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            objects_.push_back(prepare_object(setup_, scene, scene.objects[i], resources[i]));
        }
    }

    [[nodiscard]] std::size_t bands() const override {
        return static_cast<std::size_t>((size_.height + band_rows - 1) / band_rows);
    }

    void draw(std::size_t band, ReferenceFrame &frame) const override {
        const int first = static_cast<int>(band) * band_rows;
        const int end = std::min(first + band_rows, size_.height);
        const Rows rows = see_rows(std::max(first - 1, 0), std::min(end + 1, size_.height));
        for (int y = first; y < end; ++y) {
            for (int x = 0; x < size_.width; ++x) {
                shade(rows, x, y, frame);
            }
        }
    }

    [[nodiscard]] std::optional<PixelProbe> probe(int x, int y) const override {
        const Seen seen = see(x + 0.5, y + 0.5);
        if (seen.object == 0) {
            return {};
        }
        const ShapeSampler sampler(objects_[seen.object - 1], eye_, seen.hit, x + 0.5, y + 0.5);
        const SurfacePoint point = sampler.point_at(0, 0);
        const PixelMasks masks = sampler.masks();
        return PixelProbe{.object = seen.object - 1,
                          .position = point.position + setup_.eye,
                          .normal = point.normal,
                          .view = point.view,
                          .base = sampler.base(),
                          .lights = sampler.probe_lights(point),
                          .color = sampler.color(),
                          .edge = at_edge(seen, x + 0.5, y + 0.5),
                          .jump = masks.jump,
                          .rounding = masks.rounding,
                          .doubt = masks.doubt};
    }

    [[nodiscard]] std::vector<std::optional<glm::dvec3>> row(int y) const override {
        std::vector<std::optional<glm::dvec3>> colors;
        for (int x = 0; x < size_.width; ++x) {
            const Seen seen = see(x + 0.5, y + 0.5);
            colors.push_back(seen.object == 0
                                 ? std::optional<glm::dvec3>()
                                 : ShapeSampler(objects_[seen.object - 1], eye_, seen.hit, x + 0.5, y + 0.5).color());
        }
        return colors;
    }

  private:
    [[nodiscard]] Seen see(double x, double y) const {
        const Ray ray = eye_.ray(x, y);
        Seen seen;
        for (std::uint32_t i = 0; i < objects_.size(); ++i) {
            const auto hit = hit_object(objects_[i], eye_, ray);
            if (hit && (seen.object == 0 || hit->t < seen.hit.t)) {
                seen = {i + 1, *hit};
            }
        }
        return seen;
    }

    /// Does an outline or a crease run within edge_width?
    [[nodiscard]] bool at_edge(const Seen &seen, double x, double y) const {
        constexpr std::array<glm::dvec2, 4> around{
            glm::dvec2{edge_width, 0}, {-edge_width, 0}, {0, edge_width}, {0, -edge_width}};
        return std::ranges::any_of(around,
                                   [&](const glm::dvec2 &step) { return differs(see(x + step.x, y + step.y), seen); });
    }

    /// What whole rows see, one more above and below than a band has.
    struct Rows {
        int first, end, width;
        std::vector<Seen> seen;
        [[nodiscard]] const Seen &at(int x, int y) const {
            return seen[static_cast<std::size_t>(y - first) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(x)];
        }
        /// Only where a neighbour sees something else can an outline or a crease pass within a pixel.
        [[nodiscard]] bool varied_around(int x, int y) const {
            const Seen &here = at(x, y);
            for (int j = std::max(y - 1, first); j <= std::min(y + 1, end - 1); ++j) {
                for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width - 1); ++i) {
                    if (differs(at(i, j), here)) {
                        return true;
                    }
                }
            }
            return false;
        }
    };

    [[nodiscard]] Rows see_rows(int first, int end) const {
        Rows rows{first, end, size_.width, {}};
        rows.seen.reserve(static_cast<std::size_t>(end - first) * static_cast<std::size_t>(size_.width));
        for (int y = first; y < end; ++y) {
            for (int x = 0; x < size_.width; ++x) {
                rows.seen.push_back(see(x + 0.5, y + 0.5));
            }
        }
        return rows;
    }

    void shade(const Rows &rows, int x, int y, ReferenceFrame &frame) const {
        const auto pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) + static_cast<std::size_t>(x);
        const Seen &seen = rows.at(x, y);
        frame.edge[pixel] = rows.varied_around(x, y) && at_edge(seen, x + 0.5, y + 0.5) ? 1 : 0;
        if (seen.object == 0) {
            return;
        }
        const ShapeSampler sampler(objects_[seen.object - 1], eye_, seen.hit, x + 0.5, y + 0.5);
        frame.color[pixel] = sampler.color();
        frame.object_ids[pixel] = seen.object;
        frame.mark(pixel, sampler.masks());
    }

    Size size_;
    Setup setup_;
    Eye eye_;
    std::vector<AnalyticObject> objects_;
};

} // namespace

std::unique_ptr<Picture> analytic_picture(const Scene &scene, const std::vector<ObjectResources> &resources,
                                          const Technique &technique, Size size) {
    if (technique.frequency != Frequency::per_pixel || technique.attenuation != AttenuationAt::exact) {
        throw InputError("{} needs vertices, which an analytic surface does not have; expected a per-pixel "
                         "technique with attenuation=exact",
                         to_string(technique));
    }
    return std::make_unique<AnalyticPicture>(scene, resources, technique, size);
}

} // namespace sandbox::reference
