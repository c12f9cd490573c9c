#pragma once

#include "scene/scene.h"

#include <array>
#include <cstddef>
#include <string_view>

/// The kinds of light, a row each: what scene files, panels, programs and the reference ask about a kind. Its formula
/// stands in shaders/light_WORD.glsl and, in double, in reference/lighting.cpp.
namespace sandbox {

struct LightKind {
    LightType type;
    std::string_view word; ///< in scene files, in the window, and in the names of its GLSL
    bool positional;       ///< it shines from a position, and attenuation weakens it with distance
    bool directed;         ///< it has a direction
    bool conical;          ///< a cone about its direction may limit it
};

constexpr std::array light_kinds{
    LightKind{
        .type = LightType::directional, .word = "directional", .positional = false, .directed = true, .conical = false},
    LightKind{.type = LightType::point, .word = "point", .positional = true, .directed = false, .conical = false},
    LightKind{.type = LightType::spot, .word = "spot", .positional = true, .directed = true, .conical = true},
};

constexpr const LightKind &kind_of(LightType type) { return light_kinds.at(static_cast<std::size_t>(type)); }
static_assert(
    [] {
        for (const LightKind &kind : light_kinds) {
            if (kind_of(kind.type).type != kind.type) {
                return false;
            }
        }
        return true;
    }(),
    "light_kinds has a row for each LightType, in its order");

constexpr bool has_position(const Light &light) { return kind_of(light.type).positional; }
constexpr bool has_direction(const Light &light) { return kind_of(light.type).directed; }
/// 180 degrees: no cone.
constexpr bool has_cone(const Light &light) { return kind_of(light.type).conical && light.cutoff_degrees != 180; }

/// A spot light without its cone shines like a point light.
constexpr bool uses_direction(const Light &light) {
    return has_direction(light) && (has_cone(light) || !kind_of(light.type).conical);
}
/// The kind that the light is drawn as.
constexpr LightType drawn_type(const Light &light) {
    return kind_of(light.type).conical && !has_cone(light) ? LightType::point : light.type;
}

/// One T for each kind, in the order of the table.
template <class T> class ByLightKind {
  public:
    constexpr T &operator[](LightType type) { return values_[static_cast<std::size_t>(type)]; }
    constexpr const T &operator[](LightType type) const { return values_[static_cast<std::size_t>(type)]; }
    constexpr auto begin() { return values_.begin(); }
    constexpr auto end() { return values_.end(); }
    constexpr auto begin() const { return values_.begin(); }
    constexpr auto end() const { return values_.end(); }
    auto operator<=>(const ByLightKind &) const = default; // NOLINT(modernize-use-nullptr): version 14 errs

  private:
    std::array<T, light_kinds.size()> values_{};
};

} // namespace sandbox
