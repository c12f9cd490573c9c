#include "render/full_uniforms.h"

#include "scene/space.h"

namespace sandbox {
namespace {

int base_kind(const Material &material) { return material.checker ? 2 : (material.texture.empty() ? 0 : 1); }

/// Without one: every cell and colour must still be set.
void put_no_checker(Uploader &uploader) {
    uploader.put("checker_colors[0]", glm::vec3(1));
    uploader.put("checker_colors[1]", glm::vec3(1));
    uploader.put("checker_cells_per_unit", 1.0F);
    uploader.put("checker_whole", glm::vec3(0));
    uploader.put("checker_rest", glm::vec3(0));
    uploader.put("checker_last", 1.0F);
}

/// All lights that reach the object, in scene order of their kinds; the arrays' other elements are set to none.
void put_full_lights(Uploader &uploader, const DrawInput &input, double scale) {
    const ContributingLights lights = contributing_lights(input.scene, input.technique, input.object);
    int count = 0;
    for (const auto *indices : {&lights.directional, &lights.point, &lights.spot}) {
        for (const std::size_t i : *indices) {
            put_light(uploader, "lights[" + std::to_string(count++) + "]",
                      light_values(input.scene.lights[i], input.scene, input.technique, input.object.material, scale));
        }
    }
    uploader.put("light_count", count);
    uploader.skip_from("lights[", count);
}

} // namespace

void put_full_uniforms(Uploader &uploader, const DrawInput &input, double scale) {
    const Technique &technique = input.technique;
    const Material &material = input.object.material;
    put_full_lights(uploader, input, scale);
    uploader.put("ambient", glm::vec3(constant_ambient_light(input.scene, technique, material)));
    uploader.put("model_kind", static_cast<int>(technique.model));
    uploader.put("gate", static_cast<int>(technique.gate));
    uploader.put("normal_transform", static_cast<int>(scaled(normal_transform(technique, input.object), scale)));
    uploader.put("renormalize", technique.renormalize == Renormalize::on ? 1 : 0);
    uploader.put("viewer_infinite", technique.viewer == Viewer::infinite ? 1 : 0);
    uploader.put("half_vector_constant", technique.half_vector == HalfVector::constant ? 1 : 0);
    uploader.put("position_w0", technique.position == LightingPosition::w0 ? 1 : 0);
    uploader.put("ambient_where_lit", technique.ambient == AmbientWhere::where_lit ? 1 : 0);
    uploader.put("unnegated_diffuse", technique.direction == DirectionSign::unnegated_diffuse ? 1 : 0);
    uploader.put("power_kind", static_cast<int>(technique.power));
    uploader.put("two_sided", input.object.two_sided ? 1 : 0);
    uploader.put("base_kind", base_kind(material));
    const bool times_specular = base_kind(material) == 0 || material.texture_modulates_specular;
    uploader.put("base_times_specular", times_specular ? 1 : 0);
    uploader.put("specular_times_base", times_specular ? 1 : 0);
    if (!material.checker) {
        put_no_checker(uploader);
    }
}

} // namespace sandbox
