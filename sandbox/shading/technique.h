#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// How a scene is lit. Written `per-pixel/blinn-phong:power=stable`; the first value of every key is the default, and
/// right; the others are faults (each from a source document or a well-known bug) or variants.
namespace sandbox {

enum class Frequency { flat, per_vertex, per_pixel, interpolated_vectors, hybrid };
enum class Model { lambert, phong, blinn_phong };
enum class Normals { inverse_transpose, model_matrix, untransformed };
enum class Renormalize { on, off };
enum class LightingPosition { world, w0 };
enum class Gate { light_facing, view_facing, none };
enum class Viewer { local, infinite };
enum class HalfVector { exact, constant };
enum class AmbientWhere { everywhere, where_lit };
enum class DirectionSign { travel, unnegated_diffuse };
enum class AttenuationAt { exact, interpolated, distance_interpolated };
enum class Power { automatic, textbook, stable };
enum class Program { specialised, full };

struct Technique {
    Frequency frequency = Frequency::per_pixel;
    Model model = Model::blinn_phong;
    Normals normals = Normals::inverse_transpose;
    Renormalize renormalize = Renormalize::on;
    LightingPosition position = LightingPosition::world;
    Gate gate = Gate::light_facing;
    Viewer viewer = Viewer::local;
    HalfVector half_vector = HalfVector::exact;
    AmbientWhere ambient = AmbientWhere::everywhere;
    DirectionSign direction = DirectionSign::travel;
    AttenuationAt attenuation = AttenuationAt::exact;
    Power power = Power::automatic;
    Program program = Program::specialised;
    bool operator==(const Technique &) const = default;
};

/// One row of the table that parsing, printing, validation, help and the window's toggles are all made from.
struct TechniqueKey {
    struct Value {
        std::string_view name;
        std::string_view look_for; ///< one line: what it does, what to look for
    };
    std::string_view name; ///< "normals"
    std::string_view doc;
    std::vector<Value> values; ///< the first is the default
    bool fault;                ///< its other values are faults (not power, program)
    int (*get)(const Technique &);
    void (*set)(Technique &, int);
};

/// "frequency" and "model" first, then the keys in interface order.
std::span<const TechniqueKey> technique_keys();

/// Throws InputError naming the word that is wrong and what was expected; the result is valid.
Technique parse_technique(std::string_view text);
/// Only what differs from the defaults: parse_technique(to_string(t)) == t.
std::string to_string(const Technique &technique);
/// Why the combination is refused (a key that can have no effect, say); nothing if it is valid.
std::optional<std::string> why_refused(const Technique &technique);
/// Can `key` hold anything but its default under this frequency and model?
bool key_applies(const TechniqueKey &key, const Technique &technique);
/// The same frequency and model with every key that cannot apply reset to its default.
Technique nearest_valid(Technique technique);

} // namespace sandbox
