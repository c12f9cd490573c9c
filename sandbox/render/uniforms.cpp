#include "render/uniforms.h"

#include "render/full_uniforms.h"
#include "render/light_values.h"
#include "render/log_depth.h"
#include "render/placing.h"
#include "render/uploader.h"
#include "scene/space.h"
#include "shading/normal_matrix.h"

#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <glm/trigonometric.hpp>

namespace sandbox {

void put_light(Uploader &uploader, const std::string &name, const LightValues &light) {
    uploader.put(name + ".position", glm::vec3(light.position));
    uploader.put(name + ".direction", glm::vec3(light.direction));
    uploader.put(name + ".ambient", glm::vec3(light.ambient));
    uploader.put(name + ".attenuated_ambient", glm::vec3(light.attenuated_ambient));
    uploader.put(name + ".diffuse", glm::vec3(light.diffuse));
    uploader.put(name + ".specular", glm::vec3(light.specular));
    uploader.put(name + ".half_vector", glm::vec3(light.half_vector));
    uploader.put(name + ".constant", static_cast<float>(light.attenuation.constant));
    uploader.put(name + ".linear", static_cast<float>(light.attenuation.linear));
    uploader.put(name + ".quadratic", static_cast<float>(light.attenuation.quadratic));
    uploader.put(name + ".cos_cutoff", static_cast<float>(light.cos_cutoff));
    uploader.put(name + ".cos_inner_cutoff", static_cast<float>(light.cos_inner_cutoff));
    uploader.put(name + ".sin2_cutoff", static_cast<float>(light.sin2_cutoff));
    uploader.put(name + ".edge_sharpness", static_cast<float>(light.edge_sharpness));
    uploader.put(name + ".exponent", static_cast<float>(light.exponent));
    uploader.put(name + ".type", light.type);
}

namespace {

void put_lights(Uploader &uploader, const DrawInput &input, const std::string &kind,
                const std::vector<std::size_t> &indices, double scale) {
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const std::string name =
            indices.size() == 1 ? "the_" + kind + "_light" : kind + "_lights[" + std::to_string(i) + "]";
        put_light(
            uploader, name,
            light_values(input.scene.lights[indices[i]], input.scene, input.technique, input.object.material, scale));
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

void put_depth(Uploader &uploader, const LogDepth &depth) {
    uploader.put("depth_per_octave", static_cast<float>(depth.per_octave));
    uploader.put("depth_at_1", static_cast<float>(depth.at_1));
}

/// From the eye through a pixel, as far as a depth of 1 along the view.
void put_rays(Uploader &uploader, const DrawInput &input) {
    const CameraAxes axes = camera_axes(input.scene.camera);
    const double half_height = std::tan(glm::radians(input.scene.camera.fov_y_degrees) / 2);
    const glm::dvec3 up = axes.up * half_height;
    const glm::dvec3 right = axes.right * (half_height * input.aspect());
    uploader.put("ray_corner", glm::vec3(axes.forward - right - up));
    uploader.put("ray_right", glm::vec3(right * (2.0 / input.size.width)));
    uploader.put("ray_up", glm::vec3(up * (2.0 / input.size.height)));
}

} // namespace

void upload_uniforms(const GlProgram &program, const DrawInput &input) {
    Uploader uploader(program);
    const Scene &scene = input.scene;
    const Material &material = input.object.material;
    const Placing placing = place_object(scene, input.object, input.mesh);
    uploader.put("model_view_projection", glm::mat4(model_view_projection(scene, placing, input.aspect())));
    uploader.put("model", glm::mat4(placing.model));
    put_rays(uploader, input);
    put_depth(uploader, log_depth(scene.camera, placing.scale));
    uploader.put("normal_matrix", glm::mat3(normal_matrix(linear_part(input.object.transform))));
    uploader.put("eye", glm::vec3(placing.eye));
    uploader.put("view_direction", glm::vec3(-camera_axes(scene.camera).forward));
    uploader.put("shininess", static_cast<float>(raised_exponent(scene, input.technique.model, material)));
    uploader.put("emission", glm::vec3(material.emission));
    uploader.put("object_id", input.object_id);
    uploader.put("base_texture", 0);
    if (material.checker) {
        put_checker(uploader, *material.checker, input.mesh, placing.origin);
    }
    if (input.technique.program == Program::full) {
        put_full_uniforms(uploader, input, placing.scale);
    } else {
        const glm::dvec3 emission = program.has("emission") ? glm::dvec3(0) : material.emission;
        uploader.put("ambient", glm::vec3(constant_ambient_light(scene, input.technique, material) + emission));
        const ContributingLights lights = contributing_lights(scene, input.technique, input.object);
        put_lights(uploader, input, "directional", lights.directional, placing.scale);
        put_lights(uploader, input, "point", lights.point, placing.scale);
        put_lights(uploader, input, "spot", lights.spot, placing.scale);
    }
    uploader.require_all_set();
}

} // namespace sandbox
