#pragma once

#include "scene/scene.h"
#include "shading/own_text.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// What own shading may read: a row each, from which it is declared, set and explained. World space, linear colours,
/// as the scene file has them. It is apart from the uniforms of the program's own equation.
namespace sandbox {

using OwnValue = std::variant<int, float, glm::vec3, glm::mat3, glm::mat4>;

/// A name whose value comes from a `From` of the scene.
template <class From> struct OwnName {
    std::string_view type, name, doc;
    OwnValue (*value)(const From &);
};

/// What one draw is of.
struct OwnSubject {
    const Scene &scene;
    const Object &object;
};

/// The fields of `Light`, of `Material`, and the uniforms beside them.
std::span<const OwnName<Light>> own_light_fields();
std::span<const OwnName<Material>> own_material_fields();
std::span<const OwnName<OwnSubject>> own_uniforms();

/// A function that the text may define; the first it must.
struct OwnEntry {
    std::string_view signature, doc;
};
constexpr OwnEntry own_entries[]{
    {"vec3 lighting(vec3 P, vec3 N, vec3 eye)",
     "the linear colour of a point: P and eye in world space, N as interpolated, not unit"},
    {"vec3 position(vec3 p)", "from model space to P, in place of the program's own transform"},
    {"vec3 normal(vec3 n)", "from model space to N, before it is interpolated, in place of the program's own"},
};

/// The lights that are on, in the scene's order: the array `lights`.
std::vector<const Light *> own_lights(const Scene &scene);

/// The declarations of what the text names, in GLSL, a line each; `lights` is how many lights are on.
std::vector<std::string> own_declarations(const OwnText &text, int lights);

/// The whole interface as comments, a line each.
std::vector<std::string> own_interface_comments();

} // namespace sandbox
