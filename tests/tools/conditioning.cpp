#include "tools/conditioning.h"

#include "scene/space.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sandbox {
namespace {

constexpr double rounding = 0x1p-22;
constexpr double cosine_rounding = 2 * rounding;
constexpr double darkest = 1e-30; ///< below it float32 ends

double largest(const glm::dvec3 &v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// As if N.L and the highlight were 1 everywhere.
Scene facing_the_lights(Scene scene) {
    for (Light &light : scene.lights) {
        light.ambient += light.diffuse + light.specular;
        light.diffuse = light.specular = 0;
        light.attenuate_ambient = true;
    }
    for (Object &object : scene.objects) {
        Material &m = object.material;
        m.ambient = glm::max(m.ambient, glm::max(m.diffuse, m.specular));
    }
    return scene;
}

} // namespace

double reach_from(const glm::dvec3 &eye, const Object &object, const Mesh &mesh) {
    const glm::dvec3 middle = linear_part(object.transform) * (0.5 * (mesh.bounds.low + mesh.bounds.high));
    const glm::dvec3 half = 0.5 * (mesh.bounds.high - mesh.bounds.low) * object.transform.scale;
    return glm::length(middle + (object.transform.translate - eye)) + glm::length(half);
}

Scene seen_from_the_origin(Scene scene) {
    const glm::dvec3 eye = scene.camera.position;
    scene.camera.position = {};
    scene.camera.target -= eye;
    for (Object &object : scene.objects) {
        object.transform.translate -= eye;
    }
    for (Light &light : scene.lights) {
        light.position -= eye;
    }
    return scene;
}

bool reads_the_origin(const Technique &technique) {
    return technique.position != LightingPosition::world || technique.half_vector == HalfVector::constant;
}

Conditioning::Conditioning(const Scene &placed, const std::vector<ObjectResources> &resources,
                           const Technique &technique, const ReferenceFrame &truth)
    : truth_(truth), change_(truth.color.size(), 0), another_seen_(truth.color.size(), false) {
    const Scene scene = reads_the_origin(technique) ? placed : seen_from_the_origin(placed);
    const glm::dvec3 eye = scene.camera.position;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double share : {-rounding, rounding}) {
            Scene objects = scene;
            for (std::size_t i = 0; i < scene.objects.size(); ++i) {
                objects.objects[i].transform.translate[axis] +=
                    share * reach_from(eye, scene.objects[i], *resources[i].mesh);
            }
            note(render_reference(objects, resources, technique, truth.size));
            Scene lights = scene;
            for (Light &light : lights.lights) {
                light.position[axis] += share * glm::length(light.position - eye);
            }
            note(render_reference(lights, resources, technique, truth.size));
        }
    }
    double farthest = 1;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        farthest = std::max(farthest, reach_from(eye, scene.objects[i], *resources[i].mesh));
    }
    for (double &change : change_) {
        change += 0x1p-126 * farthest * std::max(truth.size.width, truth.size.height);
    }
    note_cosines(
        render_reference(facing_the_lights(scene), resources, parse_technique("per-pixel/lambert"), truth.size));
}

void Conditioning::note_cosines(const ReferenceFrame &facing) {
    for (std::size_t i = 0; i < change_.size(); ++i) {
        if (facing.object_ids[i] == truth_.object_ids[i]) {
            change_[i] += cosine_rounding * largest(facing.color[i]);
            light_ = compared(i) ? std::max(light_, largest(facing.color[i])) : light_;
        }
    }
}

void Conditioning::note(const ReferenceFrame &moved) {
    for (std::size_t i = 0; i < change_.size(); ++i) {
        if (moved.object_ids[i] == truth_.object_ids[i]) {
            change_[i] = std::max(change_[i], largest(moved.color[i] - truth_.color[i]));
        } else {
            another_seen_[i] = true;
        }
    }
}

bool Conditioning::compared(std::size_t i) const {
    return truth_.object_ids[i] != 0 && truth_.edge[i] == 0 && truth_.jump[i] == 0 && truth_.rounding[i] == 0;
}

std::size_t Conditioning::unexplained_silhouettes(const Frame &drawn) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < change_.size(); ++i) {
        count += drawn.object_ids[i] != truth_.object_ids[i] && truth_.edge[i] == 0 && !another_seen_[i] ? 1U : 0U;
    }
    return count;
}

double Conditioning::unexplained(const Frame &drawn) const {
    double brightest = darkest;
    double most = 0;
    for (std::size_t i = 0; i < change_.size(); ++i) {
        if (!compared(i)) {
            continue;
        }
        brightest = std::max(brightest, largest(truth_.color[i]));
        if (drawn.object_ids[i] == truth_.object_ids[i] && !another_seen_[i]) {
            most = std::max(most, largest(glm::dvec3(drawn.color.pixels[i]) - truth_.color[i]) - change_[i]);
        }
    }
    // A picture that is darker than what rounding makes of the cosines is black: it has no brightness of its own, and
    // its errors are shares of the light that would be there.
    return most / (brightest < cosine_rounding * light_ ? light_ : brightest);
}

} // namespace sandbox
