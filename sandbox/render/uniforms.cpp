#include "render/uniforms.h"

#include "render/light_values.h"
#include "scene/space.h"
#include "shading/own_interface.h"
#include "shading/template_values.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <span>
#include <variant>

namespace sandbox {
namespace {

/// The lights that reach the object; in a full program one array holds them all, sorted by kind.
void put_lights(Uploader &uploader, const ObjectDraw &draw) {
    const Features &program = draw.prepared.program;
    int all = 0;
    for (const LightKind &kind : light_kinds) {
        const int first = all;
        for (const ObjectLight &light : draw.prepared.lights.of_kind[kind.type]) {
            const std::string index = std::to_string(program.is_full() ? all : all - first);
            put_light(uploader, light_uniform(program, kind, index),
                      light_values(draw.scene, light, draw.object.material, draw.prepared.space));
            ++all;
        }
        if (program.is_full()) {
            uploader.put(fmt::format("{}_first", kind.word), first);
            uploader.put(fmt::format("{}_end", kind.word), all);
        }
    }
    if (program.is_full()) {
        uploader.skip_from("lights[", all);
    }
}

void put_checker(Uploader &uploader, const Checker &checker, const Mesh &mesh, const glm::dvec3 &origin) {
    const double cells_per_unit = checker.cells / (2 * half_extent(mesh));
    uploader.put("checker_colors[0]", glm::vec3(checker.colors[0]));
    uploader.put("checker_colors[1]", glm::vec3(checker.colors[1]));
    uploader.put("checker_cells_per_unit", static_cast<float>(cells_per_unit));
    const glm::dvec3 below = origin * cells_per_unit + checker.cells / 2.0;
    const glm::dvec3 whole = glm::round(below);
    uploader.put("checker_whole", glm::vec3(whole));
    uploader.put("checker_rest", glm::vec3(below - whole));
    uploader.put("checker_last", static_cast<float>(checker.cells - 1));
}

/// From the eye through a pixel, as far as a depth of 1 along the view.
void put_rays(Uploader &uploader, const ObjectDraw &draw) {
    const CameraAxes axes = camera_axes(draw.scene.camera);
    const double half_height = std::tan(glm::radians(draw.scene.camera.fov_y_degrees) / 2);
    const glm::dvec3 up = axes.up * half_height;
    const glm::dvec3 right = axes.right * (half_height * draw.aspect());
    uploader.put("ray_corner", glm::vec3(axes.forward - right - up));
    uploader.put("ray_right", glm::vec3(right * (2.0 / draw.size.width)));
    uploader.put("ray_up", glm::vec3(up * (2.0 / draw.size.height)));
}

template <class From>
void put_own(Uploader &uploader, const std::string &prefix, std::span<const OwnName<From>> rows, const From &from) {
    for (const OwnName<From> &row : rows) {
        std::visit([&](const auto &value) { uploader.put(prefix + std::string(row.name), value); }, row.value(from));
    }
}

/// The interface of own shading.
void put_own(Uploader &uploader, const ObjectDraw &draw) {
    const auto lights = own_lights(draw.scene);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        put_own(uploader, fmt::format("lights[{}].", i), own_light_fields(), *lights[i]);
    }
    uploader.skip_from("lights[", static_cast<int>(lights.size())); // an array has one element at least
    put_own(uploader, "material.", own_material_fields(), draw.object.material);
    put_own(uploader, "", own_uniforms(), OwnSubject{draw.scene, draw.object});
    uploader.put("mesh_origin", glm::vec3(draw.prepared.space.origin));
}

} // namespace

void put_choices(Uploader &uploader, const Features &object) {
    for (const auto &[name, on] : choices(object)) {
        uploader.put(uniform_name(name), on ? 1 : 0);
    }
}

void upload_uniforms(const GlProgram &program, const ObjectDraw &draw) {
    Uploader uploader(program);
    const Scene &scene = draw.scene;
    const Material &material = draw.object.material;
    const PreparedObject &prepared = draw.prepared;
    const EyeSpace &space = prepared.space;
    const glm::dmat4 to_clip = model_view_projection(scene, space, draw.aspect());
    uploader.put("model_view_projection", glm::mat4(prepared.program.deep ? without_depth(to_clip) : to_clip));
    uploader.put("model", glm::mat4(space.lit_model));
    put_rays(uploader, draw);
    uploader.put("depth_per_octave", static_cast<float>(space.depth_per_octave));
    uploader.put("depth_at_1", static_cast<float>(space.depth_at_1));
    if (prepared.program.is_own()) {
        put_own(uploader, draw);
    } else {
        const Normals normals = prepared.features.technique.normals;
        uploader.put("normal_matrix", glm::mat3(normal_matrix(normals, scene.camera, draw.object, space)));
    }
    uploader.put("eye", glm::vec3(space.eye));
    uploader.put("view_direction", glm::vec3(-camera_axes(scene.camera).forward));
    uploader.put("shininess", static_cast<float>(raised_exponent(scene, prepared.features.technique.model, material)));
    const glm::dvec3 emission = program.has("emission") ? glm::dvec3(0) : material.emission;
    uploader.put("ambient", glm::vec3(prepared.lights.constant_ambient + emission));
    uploader.put("emission", glm::vec3(material.emission));
    uploader.put("object_id", draw.object_id);
    uploader.put("exposure", static_cast<float>(draw.exposure));
    uploader.put("base_texture", 0);
    if (prepared.program.chequered) {
        put_checker(uploader, material.checker.value_or(Checker{}), draw.mesh, space.origin);
    }
    put_lights(uploader, draw);
    if (prepared.program.is_full()) {
        put_choices(uploader, prepared.features);
    }
    uploader.require_all_set();
}

} // namespace sandbox
