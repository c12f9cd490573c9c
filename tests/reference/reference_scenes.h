#pragma once

#include "reference/reference.h"
#include "scene/mesh.h"
#include "scene/resources.h"
#include "scene/scene.h"

#include <cmath>
#include <memory>
#include <vector>

/// Small scenes for the truth's tests, built without files.
namespace sandbox::test {

inline std::vector<ObjectResources> resources_of(const Scene &scene) {
    std::vector<ObjectResources> out;
    for (const Object &object : scene.objects) {
        out.push_back({std::make_shared<const Mesh>(build_mesh(object.mesh)), nullptr});
    }
    return out;
}

inline Object object_of(Shape shape) {
    Object object;
    object.name = "object";
    object.mesh = std::move(shape);
    return object;
}

inline Light point_light(glm::dvec3 position) {
    Light light;
    light.type = LightType::point;
    light.position = position;
    return light;
}

inline Light directional_light(glm::dvec3 direction) {
    Light light;
    light.type = LightType::directional;
    light.direction = direction;
    return light;
}

/// A unit sphere at the origin, seen from (0, 0, 4), lit by one point light.
inline Scene ball(glm::dvec3 light, int rings = 32) {
    Scene scene;
    scene.camera.position = {0, 0, 4};
    scene.objects.push_back(object_of(SphereShape{1, rings, 2 * rings}));
    scene.lights.push_back(point_light(light));
    return scene;
}

/// A plane from above, and a spot whose hard edge draws a circle of radius tan(30 degrees) on it.
inline Scene spot_over_a_plane() {
    Scene scene;
    scene.camera.position = {0, 3, 0};
    scene.camera.up = {0, 0, -1};
    scene.objects.push_back(object_of(PlaneShape{}));
    scene.lights.push_back(point_light({0, 1, 0}));
    Light &light = scene.lights[0];
    light.type = LightType::spot;
    light.direction = {0, -1, 0};
    light.cutoff_degrees = light.inner_cutoff_degrees = 30;
    return scene;
}

inline ReferenceFrame render(const Scene &scene, const Technique &technique, Size size,
                             Surface surface = Surface::mesh) {
    return render_reference(scene, resources_of(scene), technique, size, surface);
}

inline bool all_finite(const ReferenceFrame &frame) {
    for (const glm::dvec3 &c : frame.color) {
        if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z)) {
            return false;
        }
    }
    return true;
}

} // namespace sandbox::test
