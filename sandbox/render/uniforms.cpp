#include "render/uniforms.h"

#include "render/light_values.h"
#include "scene/space.h"
#include "shading/light_template.h"
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
void put_lights(UniformSink &sink, const ObjectDraw &draw) {
    const Features &program = draw.prepared.program;
    int all = 0;
    for (const LightKind &kind : light_kinds) {
        const int first = all;
        for (const ObjectLight &light : draw.prepared.lights.of_kind[kind.type]) {
            const std::string index = std::to_string(program.is_full() ? all : all - first);
            const LightValues values = light_values(draw.scene, light, draw.object.material, draw.prepared.space);
            put_light(sink, light_uniform(program, kind, index), values);
            if (all == first) {
                put_shared(sink, fmt::format("{}_", kind.word), values);
            }
            ++all;
        }
        if (program.is_full()) {
            sink.put(fmt::format("{}_first", kind.word), first);
            sink.put(fmt::format("{}_end", kind.word), all);
        }
    }
    if (program.is_full()) {
        sink.skip_from("lights[", all);
    }
}

void put_checker(UniformSink &sink, const Checker &checker, const Mesh &mesh, const glm::dvec3 &origin) {
    const double cells_per_unit = checker.cells / (2 * half_extent(mesh));
    sink.put("checker_colors[0]", glm::vec3(checker.colors[0]));
    sink.put("checker_colors[1]", glm::vec3(checker.colors[1]));
    sink.put("checker_cells_per_unit", static_cast<float>(cells_per_unit));
    const glm::dvec3 below = origin * cells_per_unit + checker.cells / 2.0;
    const glm::dvec3 whole = glm::round(below);
    sink.put("checker_whole", glm::vec3(whole));
    sink.put("checker_rest", glm::vec3(below - whole));
    sink.put("checker_last", static_cast<float>(checker.cells - 1));
}

/// From the eye through a pixel, as far as a depth of 1 along the view.
void put_rays(UniformSink &sink, const ObjectDraw &draw) {
    const CameraAxes axes = camera_axes(draw.scene.camera);
    const double half_height = std::tan(glm::radians(draw.scene.camera.fov_y_degrees) / 2);
    const glm::dvec3 up = axes.up * half_height;
    const glm::dvec3 right = axes.right * (half_height * draw.aspect());
    sink.put("ray_corner", glm::vec3(axes.forward - right - up));
    sink.put("ray_right", glm::vec3(right * (2.0 / draw.size.width)));
    sink.put("ray_up", glm::vec3(up * (2.0 / draw.size.height)));
}

template <class From>
void put_own(UniformSink &sink, const std::string &prefix, std::span<const OwnName<From>> rows, const From &from) {
    for (const OwnName<From> &row : rows) {
        std::visit([&](const auto &value) { sink.put(prefix + std::string(row.name), value); }, row.value(from));
    }
}

/// The interface of own shading.
void put_own(UniformSink &sink, const ObjectDraw &draw) {
    const auto lights = own_lights(draw.scene);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        put_own(sink, fmt::format("lights[{}].", i), own_light_fields(), *lights[i]);
    }
    sink.skip_from("lights[", static_cast<int>(lights.size())); // an array has one element at least
    put_own(sink, "material.", own_material_fields(), draw.object.material);
    put_own(sink, "", own_uniforms(), OwnSubject{draw.scene, draw.object});
    sink.put("mesh_origin", glm::vec3(draw.prepared.space.origin));
}

void put_uniforms(UniformSink &sink, const ObjectDraw &draw) {
    const Scene &scene = draw.scene;
    const Material &material = draw.object.material;
    const PreparedObject &prepared = draw.prepared;
    const EyeSpace &space = prepared.space;
    const glm::dmat4 to_clip = model_view_projection(scene, space, draw.aspect());
    sink.put("model_view_projection", glm::mat4(prepared.program.deep ? without_depth(to_clip) : to_clip));
    sink.put("model", glm::mat4(space.lit_model));
    put_rays(sink, draw);
    sink.put("depth_per_octave", static_cast<float>(space.depth_per_octave));
    sink.put("depth_at_1", static_cast<float>(space.depth_at_1));
    if (prepared.program.is_own()) {
        put_own(sink, draw);
    } else {
        const Normals normals = prepared.features.technique.normals;
        sink.put("normal_matrix", glm::mat3(normal_matrix(normals, scene.camera, draw.object, space)));
    }
    sink.put("eye", glm::vec3(space.eye));
    sink.put("view_direction", glm::vec3(-camera_axes(scene.camera).forward));
    sink.put("shininess", static_cast<float>(raised_exponent(scene, prepared.features.technique.model, material)));
    const glm::dvec3 emission = prepared.program.emission ? glm::dvec3(0) : material.emission;
    sink.put("ambient", glm::vec3(prepared.lights.constant_ambient + emission));
    sink.put("emission", glm::vec3(material.emission));
    sink.put("object_id", draw.object_id);
    sink.put("exposure", static_cast<float>(draw.exposure));
    sink.put("base_texture", 0);
    if (prepared.program.chequered) {
        put_checker(sink, material.checker.value_or(Checker{}), draw.mesh, space.origin);
    }
    put_lights(sink, draw);
    if (prepared.program.is_full()) {
        put_choices(sink, prepared.features);
    }
}

} // namespace

void put_choices(UniformSink &sink, const Features &object) {
    for (const auto &[name, on] : choices(object)) {
        sink.put(uniform_name(name), on ? 1 : 0);
    }
}

void upload_uniforms(const GlProgram &program, const ObjectDraw &draw) {
    Uploader uploader(program);
    put_uniforms(uploader, draw);
    uploader.require_all_set();
}

UniformValues uniform_values(const ObjectDraw &draw) {
    UniformRecorder recorder;
    put_uniforms(recorder, draw);
    return recorder.take();
}

} // namespace sandbox
