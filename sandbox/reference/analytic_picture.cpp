#include "image/error.h"
#include "reference/analytic.h"
#include "reference/picture.h"
#include "reference/raster.h"
#include "reference/surface.h"
#include "scene/space.h"

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
    Placement placement;
    glm::dmat3 inverse{1};
    BaseColor base;
};

/// What a ray through a point of the picture sees.
struct Seen {
    std::uint32_t object = 0; ///< 0 background, i + 1 objects[i]
    ShapeHit hit;
};

/// Rays from the eye, scaled so that t is the distance along the camera's axis.
struct Eye {
    CameraAxes axes;
    double tan_x, tan_y;
    Size size;
    double near, far;

    Eye(const Camera &camera, Size s)
        : axes(camera_axes(camera)), tan_x(std::tan(camera.fov_y_degrees * std::acos(-1.0) / 360) * s.width / s.height),
          tan_y(std::tan(camera.fov_y_degrees * std::acos(-1.0) / 360)), size(s), near(camera.near_plane),
          far(camera.far_plane) {}
    [[nodiscard]] glm::dvec3 direction(double x, double y) const {
        return axes.forward + axes.right * ((2 * x / size.width - 1) * tan_x) +
               axes.up * ((1 - 2 * y / size.height) * tan_y);
    }
};

std::optional<ShapeHit> hit_object(const AnalyticObject &object, const Eye &eye, const glm::dvec3 &direction) {
    return intersect(object.object->mesh, object.inverse * -object.placement.offset, object.inverse * direction,
                     eye.near, eye.far);
}

/// One shape around a pixel's centre.
class ShapeSampler : public Sampler {
  public:
    ShapeSampler(const Setup &setup, const AnalyticObject &object, const Eye &eye, const ShapeHit &hit, double x,
                 double y)
        : setup_(setup), object_(object), eye_(eye), hit_(hit), x_(x), y_(y) {}

    [[nodiscard]] ShapeHit hit_at(double dx, double dy) const {
        const auto hit = dx == 0 && dy == 0 ? hit_ : hit_object(object_, eye_, eye_.direction(x_ + dx, y_ + dy));
        return hit && hit->part == hit_.part ? *hit : hit_;
    }

    [[nodiscard]] Place at(double dx, double dy) const override {
        const ShapeHit hit = hit_at(dx, dy);
        Place place;
        place.position = object_.placement.lit(hit.position);
        place.raw_normal = transform_normal(object_.placement.normals, hit.normal);
        place.view = view_vector(setup_, place.position);
        place.normal = facing(object_.object->two_sided, place.raw_normal, place.view);
        return place;
    }

    [[nodiscard]] LightVectors vectors(const Place &place, std::size_t light) const override {
        return light_vectors(setup_, setup_.lights[light], place.position, place.normal, place.view);
    }

    [[nodiscard]] glm::dvec3 base() const { return object_.base.at(hit_.uv, hit_.position); }

    [[nodiscard]] bool unstable() const {
        const Place here = at(0, 0);
        return checker_unstable() ||
               may_jump(setup_, object_.object->material, object_.object->two_sided, Terms::all, here, *this);
    }

  private:
    [[nodiscard]] bool checker_unstable() const {
        const Checker *checker = object_.base.checker;
        if (checker == nullptr || checker->colors[0] == checker->colors[1]) {
            return false;
        }
        const auto cells = [&](const ShapeHit &hit) {
            return checker_coordinates(*checker, object_.base.half_extent, hit.position);
        };
        const glm::dvec3 here = cells(hit_);
        const glm::dvec3 change =
            glm::abs(cells(hit_at(edge_width, 0)) - here) + glm::abs(cells(hit_at(0, edge_width)) - here);
        for (int axis = 0; axis < 3; ++axis) {
            const double boundary = std::round(here[axis]);
            if (boundary > 0 && boundary < checker->cells && std::abs(here[axis] - boundary) < change[axis]) {
                return true;
            }
        }
        return false;
    }

    const Setup &setup_;
    const AnalyticObject &object_;
    const Eye &eye_;
    const ShapeHit &hit_;
    double x_, y_;
};

AnalyticObject prepare_object(const Setup &setup, const Object &object, const ObjectResources &resources) {
    if (const auto *obj = std::get_if<ObjShape>(&object.mesh)) {
        throw InputError("--surface analytic: " + object.name + " is the mesh " + obj->path +
                         ", which has no analytic surface; use --surface mesh");
    }
    AnalyticObject prepared{&object, place(object.transform, setup), glm::dmat3(1), base_color(object, resources)};
    const glm::dvec3 &scale = object.transform.scale;
    if (scale.x == 0 || scale.y == 0 || scale.z == 0) {
        throw InputError("--surface analytic: " + object.name +
                         " is flattened by a scale of 0 and has no analytic surface; use --surface mesh");
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
            objects_.push_back(prepare_object(setup_, scene.objects[i], resources[i]));
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
        const AnalyticObject &object = objects_[seen.object - 1];
        const ShapeSampler sampler(setup_, object, eye_, seen.hit, x + 0.5, y + 0.5);
        PixelProbe probe = probe_place(setup_, object.object->material, sampler.at(0, 0), sampler);
        probe.object = seen.object - 1;
        probe.base = sampler.base();
        probe.color = color(object, sampler);
        probe.edge = at_edge(seen, x + 0.5, y + 0.5);
        probe.jump = sampler.unstable();
        return probe;
    }

  private:
    [[nodiscard]] Seen see(double x, double y) const {
        const glm::dvec3 direction = eye_.direction(x, y);
        Seen seen;
        for (std::uint32_t i = 0; i < objects_.size(); ++i) {
            const auto hit = hit_object(objects_[i], eye_, direction);
            if (hit && (seen.object == 0 || hit->t < seen.hit.t)) {
                seen = {i + 1, *hit};
            }
        }
        return seen;
    }

    [[nodiscard]] glm::dvec3 color(const AnalyticObject &object, const ShapeSampler &sampler) const {
        const Material &material = object.object->material;
        return compose(material, sampler.base(), reflect(setup_, material, Terms::all, sampler.at(0, 0), sampler));
    }

    /// Another object or another face within edge_width: an outline or a crease.
    [[nodiscard]] bool at_edge(const Seen &seen, double x, double y) const {
        constexpr std::array<glm::dvec2, 4> around{
            glm::dvec2{edge_width, 0}, {-edge_width, 0}, {0, edge_width}, {0, -edge_width}};
        return std::ranges::any_of(around, [&](const glm::dvec2 &step) {
            const Seen other = see(x + step.x, y + step.y);
            return other.object != seen.object || other.hit.part != seen.hit.part;
        });
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
                    if (at(i, j).object != here.object || at(i, j).hit.part != here.hit.part) {
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
        const AnalyticObject &object = objects_[seen.object - 1];
        const ShapeSampler sampler(setup_, object, eye_, seen.hit, x + 0.5, y + 0.5);
        frame.color[pixel] = color(object, sampler);
        frame.object_ids[pixel] = seen.object;
        frame.jump[pixel] = sampler.unstable() ? 1 : 0;
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
        throw InputError("--surface analytic: " + to_string(technique) +
                         " needs vertices, which an analytic surface has not; use a per-pixel technique with "
                         "attenuation=exact, or --surface mesh");
    }
    return std::make_unique<AnalyticPicture>(scene, resources, technique, size);
}

} // namespace sandbox::reference
