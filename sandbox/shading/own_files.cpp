#include "shading/own_files.h"

#include "scene/light_kind.h"
#include "scene/mesh.h"
#include "shading/object_lights.h"
#include "shading/own_interface.h"
#include "shading/template.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sandbox {
namespace {

/// Is there a light that is on, or an object, as asked? Where no scene is known: yes.
bool any_light(const Scene *scene, bool (*asked)(const Light &)) {
    return scene == nullptr ||
           std::ranges::any_of(scene->lights, [&](const Light &light) { return light.enabled && asked(light); });
}
/// Have the vertices colours? A model that nobody has read yet may have.
bool may_have_colors(const Shape &shape) {
    const auto *obj = std::get_if<ObjShape>(&shape);
    return obj != nullptr &&
           (obj->mesh != nullptr ? !obj->mesh->colors.empty() : std::filesystem::path(obj->path).is_absolute());
}
bool any_base(const Scene *scene) {
    return scene == nullptr || std::ranges::any_of(scene->objects, [](const Object &object) {
               return object.material.checker || !object.material.texture.empty() || may_have_colors(object.mesh);
           });
}

TemplateValues values_for(const OwnReader &reader, const Technique &technique) {
    const std::string frequency(frequency_key.value(technique).name);
    const std::string model(model_key.value(technique).name);
    const bool per_pixel = technique.frequency == Frequency::per_pixel; // as the reference is
    TemplateValues values;
    values.texts = {
        {"scene", reader.name},
        {"scene_title", reader.scene == nullptr ? "any scene" : "the scene " + reader.name},
        {"frequency", frequency},
        {"reference", fmt::format("reference:{}model={}", per_pixel ? "" : "frequency=" + frequency + ",", model)},
        {"model_title", std::string(model_key.value(technique).title)},
        {"signature", std::string(own_entries[0].signature)}};
    return values;
}

} // namespace

std::string own_starter(const OwnReader &reader, const Technique &technique, const ShaderParts &parts) {
    TemplateValues values = values_for(reader, technique);
    std::vector<std::string> entries;
    for (const OwnEntry &entry : own_entries) {
        entries.push_back(fmt::format("//   {} // {}", entry.signature, entry.doc));
    }
    values.texts["interface"] = fmt::format("{}", fmt::join(own_interface_comments(), "\n"));
    values.texts["entries"] = fmt::format("{}", fmt::join(entries, "\n"));
    values.texts["turns"] = std::to_string(most_own_turns);
    return expand(parts, "own_starter.glsl", values).text;
}

std::string own_answer(const OwnReader &reader, const Technique &technique, const ShaderParts &parts) {
    const Scene *scene = reader.scene;
    const auto any = [&](bool (*asked)(const Light &)) { return any_light(scene, asked); };
    const Reflection reflects = reflection(technique.model);
    const bool cone = any([](const Light &l) { return has_cone(l); });
    const bool directional = any([](const Light &l) { return !has_position(l); });
    TemplateValues values = values_for(reader, technique);
    values.flags = {
        {"specular", reflects.specular},
        {"half_vector", reflects.half_vector},
        {"scaled", reflects.scaled_exponent && (scene == nullptr || scene->blinn_exponent_scale != 1)},
        {"orthographic", scene != nullptr && is_orthographic(scene->camera)},
        {"directional", directional},
        {"positional", any([](const Light &l) { return has_position(l); })},
        {"attenuated", any([](const Light &l) { return has_position(l) && l.attenuation != Attenuation{}; })},
        {"cone", cone},
        {"soft", any([](const Light &l) { return has_cone(l) && has_soft_edge(l); })},
        {"hard", any([](const Light &l) { return has_cone(l) && !has_soft_edge(l); })},
        {"exponent", any([](const Light &l) { return has_cone(l) && l.exponent != 0; })},
        {"attenuates_ambient", any([](const Light &l) { return l.attenuate_ambient && fades(l); })},
        {"base", any_base(scene)}};
    return expand(parts, "own_answer.glsl", values).text;
}

} // namespace sandbox
