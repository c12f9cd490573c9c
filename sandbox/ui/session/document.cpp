#include "ui/session/document.h"

#include "scene/scene_format.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <utility>

namespace sandbox {

namespace {

/// Documents are many and small: who draws one keeps its meshes.
Scene without_meshes(Scene scene) {
    for (Object &object : scene.objects) {
        if (auto *obj = std::get_if<ObjShape>(&object.mesh)) {
            obj->mesh = nullptr;
        }
    }
    return scene;
}

} // namespace

Document document_of(std::string name, const Scene &scene, const Technique &left, const Technique &right) {
    Document document;
    document.scene = without_meshes(scene);
    document.left = left;
    document.right = right;
    document.opened = std::make_shared<const OpenedScene>(OpenedScene{std::move(name), document.scene});
    return document;
}

Scene scene_in_view(const Document &document, Size view) {
    Scene seen = document.scene;
    const double aspect = aspect_of(view);
    if (aspect < document.least_aspect && is_orthographic(seen.camera)) {
        seen.camera.height = nearest_accepted(seen.camera.height * document.least_aspect / aspect, positive_length);
    } else if (aspect < document.least_aspect) {
        const double half = glm::radians(seen.camera.fov_y_degrees) / 2;
        const double widened = 2 * std::atan(std::tan(half) * document.least_aspect / aspect);
        seen.camera.fov_y_degrees = std::min(glm::degrees(widened), 179.0);
    }
    return seen;
}

} // namespace sandbox
