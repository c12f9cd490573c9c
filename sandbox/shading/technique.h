#pragma once

#include "shading/own_shader.h"
#include "shading/technique_rules.h"

#include <array>
#include <compare>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// How a scene is lit. Written `per-pixel/blinn-phong:power=stable`; the first value of every key is the default, and
/// right; the others are faults (each from a source document or a well-known bug) or variants.
///
/// The table below is all that parsing, validation, help, the window and the programs know of a key: a value is the
/// flag key_value ("gate_none") of the shader parts and, in the full program, a uniform of that name.
/// A new value is an enumerator and the row beside it.
namespace sandbox {

struct TechniqueValue {
    std::string_view name;                 ///< in commands and files: "model-matrix"
    std::string_view title;                ///< in front of people: "model matrix"
    std::string_view look_for;             ///< one line: what it does, what to look for
    rules::CanMatter can_matter = nullptr; ///< nullptr: in every scene
    rules::Refusal why_refused = nullptr;  ///< nullptr: allowed beside every other key
};

/// The enumerators that `rows` stand beside.
template <class Enum, std::size_t N> constexpr std::array<Enum, N> enumerators(const TechniqueValue (&)[N]) {
    std::array<Enum, N> all{};
    for (std::size_t i = 0; i < N; ++i) {
        all[i] = static_cast<Enum>(i);
    }
    return all;
}

enum class Frequency { flat, per_vertex, per_pixel, interpolated_vectors, hybrid, automatic };
inline constexpr TechniqueValue frequency_values[]{
    {"flat", "flat", "once a triangle, with the face's own normal at its centroid"},
    {"per-vertex", "per vertex",
     "Gouraud shading: at each vertex, the colour is interpolated; highlights smear or vanish"},
    {"per-pixel", "per pixel", "Phong shading: position and normal are interpolated, the equation runs at each pixel"},
    {"interpolated-vectors", "interpolated vectors",
     "N, L, H (or R) and the distance are computed per vertex and interpolated"},
    {"hybrid", "hybrid", "ambient and diffuse per vertex, specular per pixel"},
    {"auto", "automatic",
     "per vertex where that provably differs from per pixel by at most the tolerance, else per pixel"},
};
inline constexpr auto all_frequencies = enumerators<Frequency>(frequency_values);

/// From the plainest on. `own` has no equation here: its text does all that a reflection model and its keys do.
enum class Model { lambert, phong, blinn_phong, own };
inline constexpr TechniqueValue model_values[]{
    {"lambert", "Lambert", "diffuse only"},
    {"phong", "Phong", "specular from the mirrored light direction: (R.V)^n"},
    {"blinn-phong", "Blinn-Phong", "specular from the half vector: (N.H)^n"},
    {"own", "own shading", "the text of --own FILE: your own shader, to be held against the truth", nullptr,
     rules::needs_own_text},
};
/// Those that have an equation, and so a truth: what goes through models goes through these. Reports begin with the
/// last.
inline constexpr std::array all_models{Model::lambert, Model::phong, Model::blinn_phong};
/// What a reflection model's specular term is made of.
struct Reflection {
    bool specular;        ///< there is one
    bool half_vector;     ///< H in place of R
    bool scaled_exponent; ///< by the scene's blinn_exponent_scale
};
constexpr Reflection reflection(Model model) {
    constexpr Reflection rows[]{{false, false, false}, {true, false, false}, {true, true, true}, {false, false, false}};
    static_assert(std::size(rows) == std::size(model_values), "a Reflection for each model");
    return rows[static_cast<int>(model)];
}
constexpr bool mirrors_view(Model model) { return reflection(model).specular && !reflection(model).half_vector; }

enum class Normals { inverse_transpose, model_matrix, untransformed, unnormalized, cofactor, view_space };
inline constexpr TechniqueValue normals_values[]{
    {"inverse-transpose", "normal matrix", "right under every transform"},
    {"model-matrix", "model matrix", "wrong under non-uniform scale: look at squashed objects",
     rules::scales_normals_unevenly},
    {"untransformed", "untransformed", "the light seems to turn with the object", rules::transforms_normals},
    {"unnormalized", "never made unit", "the transform's scale stays in N: a scaled object is too bright or too dark",
     rules::reads_normal_lengths},
    {"cofactor", "cofactors without a sign", "the determinant's sign is forgotten: light from the wrong side",
     rules::mirrors_normals},
    {"view-space", "in view space", "N in view space, all else in world space: light turns with the camera",
     rules::turns_normals_to_view},
};

enum class Renormalize { on, off };
inline constexpr TechniqueValue renormalize_values[]{
    {"on", "on", "right"},
    {"off", "off", "highlights dim in the middle of large triangles", rules::reads_normals_per_pixel,
     rules::needs_unit_normals_per_pixel},
};

enum class LightingPosition { world, w0, absolute };
inline constexpr TechniqueValue position_values[]{
    {"world", "world space", "right"},
    {"w0", "without translation", "w = 0 drops the translation: objects are lit as if they stood at the origin",
     rules::reads_translation},
    {"absolute", "absolute float32", "float32 world coordinates: far from the world's origin, lighting falls apart",
     rules::reads_positions},
};

enum class Gate { light_facing, view_facing, none, times_n_dot_l };
inline constexpr TechniqueValue gate_values[]{
    {"light-facing", "N.L > 0", "right: N.L > 0"},
    {"view-facing", "N.V > 0", "N.V > 0: highlights on surfaces that the light cannot reach", rules::has_specular,
     rules::needs_specular},
    {"none", "none", "no test: highlights shine through from behind", rules::has_specular, rules::needs_specular},
    {"times-n-dot-l", "times N.L",
     "times N.L in place of the test: the highlight's cut edge is gone, and grazing light has lost its highlight",
     rules::has_specular, rules::needs_specular},
};

enum class Facing { winding, view };
inline constexpr TechniqueValue facing_values[]{
    {"winding", "by winding", "right: N is turned where a triangle shows its back"},
    {"view", "where N.V < 0", "two-sided objects: N turned where N.V < 0; light leaks in along outlines, and sparkles",
     rules::turns_normals},
};

enum class Viewer { local, infinite };
inline constexpr TechniqueValue viewer_values[]{
    {"local", "local", "right: V from each point to the eye"},
    {"infinite", "at infinity", "one V for the whole picture: highlights drift towards the edges", rules::reads_view},
};

enum class HalfVector { exact, constant };
inline constexpr TechniqueValue half_vector_values[]{
    {"exact", "exact", "right: from each point's own L and V"},
    {"constant", "one per light", "one per light, from the origin: a point light's highlight sits in the wrong place",
     rules::has_specular, rules::needs_half_vector},
};

enum class AmbientWhere { everywhere, where_lit };
inline constexpr TechniqueValue ambient_values[]{
    {"everywhere", "everywhere", "right"},
    {"where-lit", "only where lit", "only where N.L > 0: a step along the terminator", rules::has_light_ambient},
};

enum class DirectionSign { travel, unnegated_diffuse };
inline constexpr TechniqueValue direction_values[]{
    {"travel", "negated", "right: it points the way light travels"},
    {"unnegated-diffuse", "not negated for diffuse", "diffuse uses N.D: the side away from the light is lit",
     rules::has_directional_diffuse},
};

enum class AttenuationAt { exact, interpolated, distance_interpolated };
inline constexpr TechniqueValue attenuation_values[]{
    {"exact", "exact", "from the distance of the point that is shaded"},
    {"interpolated", "interpolated", "per vertex, then interpolated: wrong on large triangles",
     rules::attenuates_per_pixel, rules::needs_attenuation_per_pixel},
    {"distance-interpolated", "interpolated distance",
     "from the interpolated distance: wrong on large triangles, less so", rules::attenuates_per_pixel,
     rules::needs_exact_distances},
};

enum class Power { automatic, textbook, stable, naive };
inline constexpr TechniqueValue power_values[]{
    {"auto", "automatic", "pow() below n = 1024, the stable form from there"},
    {"textbook", "textbook", "pow(): its error grows with n", rules::raises_large_exponents},
    {"stable", "stable",
     "exp(n log(1 - x)) from the small quantity x itself: within 2e-5 to n = 1e4, 6.5e-4 (Phong) at 1e7",
     rules::raises_small_exponents},
    {"naive", "naive", "pow() and normalize() as people write them: undefined at pow(0, 0) and normalize(0)",
     rules::has_light, rules::needs_specialised_program},
};

enum class Normalisation { none, blinn_phong };
inline constexpr TechniqueValue normalisation_values[]{
    {"none", "none", "the equation as it is"},
    {"blinn-phong", "Blinn-Phong",
     "(n + 8) / (8 pi) times specular, 1 / pi times diffuse: keeps energy with gate=times-n-dot-l only",
     rules::has_diffuse_or_specular, rules::needs_half_vector},
};

enum class Precision { high, medium };
inline constexpr TechniqueValue precision_values[]{
    {"high", "high", "float32, as measured"},
    {"medium", "medium", "every operation rounded to half; a device may keep more, or promise less", nullptr,
     rules::needs_rounded_pixels},
};

enum class Program { specialised, baked, full };
inline constexpr TechniqueValue program_values[]{
    {"specialised", "specialised", "only what this scene needs"},
    {"baked", "baked", "lights, material and matrices are written in as constants, for as long as nothing moves"},
    {"full", "full", "one program per frequency that branches on uniforms"},
};

/// tolerance=T, the one key that is a number: by how much the picture of `auto` may differ from per-pixel's, in linear
/// units, in (0, 1].
inline constexpr std::string_view tolerance_name = "tolerance";
inline constexpr std::string_view tolerance_doc = "of the frequency auto: by how much its picture may differ from "
                                                  "per-pixel's, in linear colour, above 0 to 1 [1/255]";
constexpr double default_tolerance = 1.0 / 255;

struct Technique {
    Frequency frequency = Frequency::per_pixel;
    Model model = Model::blinn_phong;
    Normals normals = Normals::inverse_transpose;
    Renormalize renormalize = Renormalize::on;
    LightingPosition position = LightingPosition::world;
    Gate gate = Gate::light_facing;
    Facing facing = Facing::winding;
    Viewer viewer = Viewer::local;
    HalfVector half_vector = HalfVector::exact;
    AmbientWhere ambient = AmbientWhere::everywhere;
    DirectionSign direction = DirectionSign::travel;
    AttenuationAt attenuation = AttenuationAt::exact;
    Power power = Power::automatic;
    Normalisation normalisation = Normalisation::none;
    Precision precision = Precision::high;
    Program program = Program::specialised;
    double tolerance = default_tolerance; ///< of the frequency auto alone: see tolerance_name
    OwnShader own{};                      ///< of Model::own; no key, so that it is not written with the others
    auto operator<=>(const Technique &) const = default; // NOLINT(modernize-use-nullptr): version 14 errs
};

struct TechniqueKey {
    enum class Kind { choice, fault, variant }; ///< choice: no value is more right than another
    std::string_view name;                      ///< "half_vector"
    std::string_view title;                     ///< "half vector"
    std::string_view doc;
    Kind kind;
    std::span<const TechniqueValue> values; ///< the first is the default
    int (*get)(const Technique &);          ///< index of its value
    void (*set)(Technique &, int);

    [[nodiscard]] bool is_fault() const { return kind == Kind::fault; }
    [[nodiscard]] const TechniqueValue &value(const Technique &technique) const {
        return values[static_cast<std::size_t>(get(technique))];
    }
};

template <auto Member>
constexpr TechniqueKey technique_key(TechniqueKey::Kind kind, std::string_view name, std::string_view title,
                                     std::string_view doc, std::span<const TechniqueValue> values) {
    using Value = std::remove_cvref_t<decltype(Technique{}.*Member)>;
    return {name,
            title,
            doc,
            kind,
            values,
            [](const Technique &technique) { return static_cast<int>(technique.*Member); },
            [](Technique &technique, int value) { technique.*Member = static_cast<Value>(value); }};
}
template <auto Member> constexpr TechniqueKey choice_key(const auto &...row) {
    return technique_key<Member>(TechniqueKey::Kind::choice, row...);
}
template <auto Member> constexpr TechniqueKey fault_key(const auto &...row) {
    return technique_key<Member>(TechniqueKey::Kind::fault, row...);
}
template <auto Member> constexpr TechniqueKey variant_key(const auto &...row) {
    return technique_key<Member>(TechniqueKey::Kind::variant, row...);
}

inline constexpr TechniqueKey frequency_key = choice_key<&Technique::frequency>(
    "frequency", "frequency", "where the lighting equation is evaluated", frequency_values);
inline constexpr TechniqueKey model_key =
    choice_key<&Technique::model>("model", "model", "the reflection model", model_values);
/// The keys that are written key=value, in the interface's order.
inline constexpr TechniqueKey technique_settings[]{
    fault_key<&Technique::normals>("normals", "normals", "how normals go to world space", normals_values),
    fault_key<&Technique::renormalize>("renormalize", "renormalize",
                                       "make the interpolated normal unit again per pixel", renormalize_values),
    fault_key<&Technique::position>("position", "position", "where lighting takes the surface to be", position_values),
    fault_key<&Technique::gate>("gate", "specular gate", "where specular light is allowed", gate_values),
    fault_key<&Technique::facing>("facing", "facing", "where the normal of a two-sided object is turned",
                                  facing_values),
    fault_key<&Technique::viewer>("viewer", "viewer", "the direction to the viewer", viewer_values),
    fault_key<&Technique::half_vector>("half_vector", "half vector", "the half vector of a light", half_vector_values),
    fault_key<&Technique::ambient>("ambient", "ambient", "where a light's ambient term is added", ambient_values),
    fault_key<&Technique::direction>("direction", "light direction", "the sign of a directional light's direction",
                                     direction_values),
    fault_key<&Technique::attenuation>("attenuation", "attenuation", "where attenuation is computed",
                                       attenuation_values),
    variant_key<&Technique::power>("power", "power", "how f^n is computed in float32", power_values),
    variant_key<&Technique::normalisation>("normalisation", "normalisation",
                                           "a factor that keeps the energy of highlights", normalisation_values),
    variant_key<&Technique::precision>("precision", "precision", "how the fragment stage and its varyings compute",
                                       precision_values),
    variant_key<&Technique::program>("program", "program", "the GLSL program", program_values),
};

/// Frequency, model, then the settings.
std::span<const TechniqueKey> technique_keys();

/// Throws InputError naming the word that is wrong and what was expected; the result is valid.
Technique parse_technique(std::string_view text);
/// `own` is the text of the model `own`, which is refused without one; other models leave it.
Technique parse_technique_with(const OwnShader &own, std::string_view text);
/// Only what differs from the defaults: parse_technique_with(t.own, to_string(t)) == t.
std::string to_string(const Technique &technique);
/// For people: "per vertex, Phong; normals: model matrix (wrong)".
std::string title_of(const Technique &technique);
/// "normals: model matrix (wrong)"; of frequency and model the value's title alone.
std::string title_of(const TechniqueKey &key, int value);

/// Why the combination is refused (a key that can have no effect, say); nothing if it is valid.
std::optional<std::string> why_refused(const Technique &technique);
/// The same with every value that is refused reset to the first of its key.
Technique nearest_valid(Technique technique);
/// What `auto` draws a triangle with: the same technique under one of its two frequencies, without the keys that mean
/// nothing there. Other techniques: as they are.
Technique part_of_auto(const Technique &technique, Frequency frequency);
/// Can this value change the picture of the scene, the other keys being those of `technique`? Sharp enough to be told
/// to people: where the answer is no, the reference draws the very picture of the key's default.
bool can_matter(const TechniqueKey &key, int value, const Scene &scene, const Technique &technique);
/// The settings that `technique` changes from their defaults though that changes no pixel of the scene.
std::vector<TechniqueKey> settings_without_effect(const Scene &scene, const Technique &technique);

} // namespace sandbox
