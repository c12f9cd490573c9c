#include "shading/technique.h"

#include "image/error.h"

#include <algorithm>
#include <array>

namespace sandbox {
namespace {

template <auto Member> int get(const Technique &technique) { return static_cast<int>(technique.*Member); }

template <auto Member> void set(Technique &technique, int value) {
    auto &field = technique.*Member;
    field = static_cast<std::remove_reference_t<decltype(field)>>(value);
}

template <auto Member>
TechniqueKey key(std::string_view name, std::string_view doc, bool fault, std::vector<TechniqueKey::Value> values) {
    return {name, doc, std::move(values), fault, get<Member>, set<Member>};
}

const std::vector<TechniqueKey> &table() {
    static const std::vector<TechniqueKey> keys{
        key<&Technique::frequency>(
            "frequency", "where the lighting equation is evaluated", false,
            {{"flat", "once a triangle, with the face's own normal at its centroid"},
             {"per-vertex", "Gouraud shading: at each vertex, the colour is interpolated; highlights smear or vanish"},
             {"per-pixel", "Phong shading: position and normal are interpolated, the equation runs at each pixel"},
             {"interpolated-vectors", "N, L, H (or R) and the distance are computed per vertex and interpolated"},
             {"hybrid", "ambient and diffuse per vertex, specular per pixel"}}),
        key<&Technique::model>("model", "the reflection model", false,
                               {{"lambert", "diffuse only"},
                                {"phong", "specular from the mirrored light direction: (R.V)^n"},
                                {"blinn-phong", "specular from the half vector: (N.H)^n"}}),
        key<&Technique::normals>("normals", "how normals go to world space", true,
                                 {{"inverse-transpose", "right under every transform"},
                                  {"model-matrix", "wrong under non-uniform scale: look at squashed objects"},
                                  {"untransformed", "the light seems to turn with the object"}}),
        key<&Technique::renormalize>("renormalize", "make the interpolated normal unit again per pixel", true,
                                     {{"on", "right"}, {"off", "highlights dim in the middle of large triangles"}}),
        key<&Technique::position>(
            "position", "where lighting takes the surface to be", true,
            {{"world", "right"},
             {"w0", "w = 0 drops the translation: objects are lit as if they stood at the origin"}}),
        key<&Technique::gate>("gate", "where specular light is allowed", true,
                              {{"light-facing", "right: N.L > 0"},
                               {"view-facing", "N.V > 0: highlights on surfaces that the light cannot reach"},
                               {"none", "no test: highlights shine through from behind"}}),
        key<&Technique::viewer>("viewer", "the direction to the viewer", true,
                                {{"local", "right: V from each point to the eye"},
                                 {"infinite", "one V for the whole picture: highlights drift towards the edges"}}),
        key<&Technique::half_vector>(
            "half_vector", "the half vector of a light", true,
            {{"exact", "right: from each point's own L and V"},
             {"constant", "one per light, from the origin: a point light's highlight sits in the wrong place"}}),
        key<&Technique::ambient>(
            "ambient", "where a light's ambient term is added", true,
            {{"everywhere", "right"}, {"where-lit", "only where N.L > 0: a step along the terminator"}}),
        key<&Technique::direction>("direction", "the sign of a directional light's direction", true,
                                   {{"travel", "right: it points the way light travels"},
                                    {"unnegated-diffuse", "diffuse uses N.D: the side away from the light is lit"}}),
        key<&Technique::attenuation>(
            "attenuation", "where attenuation is computed", true,
            {{"exact", "from the distance of the point that is shaded"},
             {"interpolated", "per vertex, then interpolated: wrong on large triangles"},
             {"distance-interpolated", "from the interpolated distance: wrong on large triangles, less so"}}),
        key<&Technique::power>("power", "how f^n is computed in float32", false,
                               {{"auto", "pow() below n = 1024, the stable form from there"},
                                {"textbook", "pow(): its error grows with n"},
                                {"stable", "exp(n log(1 - x)) from the small quantity x itself"}}),
        key<&Technique::program>("program", "the GLSL program", false,
                                 {{"specialised", "only what this scene needs"},
                                  {"full", "one program per frequency that branches on uniforms"}}),
    };
    return keys;
}

std::string expected_values(const TechniqueKey &key) {
    std::string text;
    for (const auto &value : key.values) {
        text += (text.empty() ? "" : "|") + std::string(value.name);
    }
    return text;
}

int parse_value(const TechniqueKey &key, std::string_view word, std::string_view technique) {
    const auto found = std::ranges::find(key.values, word, &TechniqueKey::Value::name);
    if (found == key.values.end()) {
        throw InputError("technique '" + std::string(technique) + "': " + std::string(key.name) + ": expected " +
                         expected_values(key) + ", got '" + std::string(word) + "'");
    }
    return static_cast<int>(found - key.values.begin());
}

void parse_setting(Technique &result, std::string_view setting, std::string_view technique) {
    const auto equals = setting.find('=');
    const auto name = setting.substr(0, equals);
    const auto keys = technique_keys().subspan(2);
    const auto found = std::ranges::find(keys, name, &TechniqueKey::name);
    if (equals == std::string_view::npos || found == keys.end()) {
        std::string names;
        for (const auto &key : keys) {
            names += (names.empty() ? "" : ", ") + std::string(key.name);
        }
        throw InputError("technique '" + std::string(technique) + "': expected key=value with key one of " + names +
                         ", got '" + std::string(setting) + "'");
    }
    found->set(result, parse_value(*found, setting.substr(equals + 1), technique));
}

bool has_pixel_specular(const Technique &t) {
    return t.frequency == Frequency::per_pixel || t.frequency == Frequency::interpolated_vectors ||
           (t.frequency == Frequency::hybrid && t.model != Model::lambert);
}

/// Why a key may not leave its default under this frequency and model; empty where it may.
std::string why_no_effect(const Technique &t, std::string_view key) {
    if (key == "renormalize" && !has_pixel_specular(t)) {
        return "no normal is interpolated under this frequency and model";
    }
    if (key == "gate" && t.model == Model::lambert) {
        return "lambert has no specular term";
    }
    if (key == "half_vector" && t.model != Model::blinn_phong) {
        return "only blinn-phong has a half vector";
    }
    if (key == "attenuation" && !has_pixel_specular(t)) {
        return "nothing is attenuated per pixel under this frequency and model";
    }
    return {};
}

} // namespace

std::span<const TechniqueKey> technique_keys() { return table(); }

bool key_applies(const TechniqueKey &key, const Technique &technique) {
    return why_no_effect(technique, key.name).empty();
}

std::optional<std::string> why_refused(const Technique &technique) {
    for (const auto &key : technique_keys().subspan(2)) {
        if (key.get(technique) == 0) {
            continue;
        }
        if (const auto reason = why_no_effect(technique, key.name); !reason.empty()) {
            const auto value = key.values[static_cast<std::size_t>(key.get(technique))].name;
            return std::string(key.name) + "=" + std::string(value) + " can have no effect: " + reason;
        }
    }
    if (technique.frequency == Frequency::interpolated_vectors &&
        technique.attenuation == AttenuationAt::distance_interpolated) {
        return "attenuation=distance-interpolated can have no effect: interpolated-vectors always interpolates the "
               "distance";
    }
    if (technique.program == Program::full && technique.attenuation != AttenuationAt::exact) {
        return "attenuation=interpolated and distance-interpolated need a varying for every light, which program=full "
               "does not carry";
    }
    return std::nullopt;
}

Technique parse_technique(std::string_view text) {
    Technique result;
    const auto keys = technique_keys();
    const auto slash = text.find('/');
    if (slash == std::string_view::npos) {
        throw InputError("technique '" + std::string(text) + "': expected FREQUENCY/MODEL[:key=value,...], e.g. " +
                         "per-pixel/blinn-phong; FREQUENCY " + expected_values(keys[0]) + ", MODEL " +
                         expected_values(keys[1]));
    }
    const auto colon = text.find(':', slash);
    keys[0].set(result, parse_value(keys[0], text.substr(0, slash), text));
    keys[1].set(result, parse_value(keys[1], text.substr(slash + 1, colon - slash - 1), text));
    if (colon != std::string_view::npos) {
        std::string_view rest = text.substr(colon + 1);
        while (true) {
            const auto comma = rest.find(',');
            parse_setting(result, rest.substr(0, comma), text);
            if (comma == std::string_view::npos) {
                break;
            }
            rest.remove_prefix(comma + 1);
        }
    }
    if (const auto reason = why_refused(result)) {
        throw InputError("technique '" + std::string(text) + "' is refused: " + *reason);
    }
    return result;
}

std::string to_string(const Technique &technique) {
    const auto keys = technique_keys();
    const auto word = [&](const TechniqueKey &key) {
        return std::string(key.values[static_cast<std::size_t>(key.get(technique))].name);
    };
    std::string text = word(keys[0]) + "/" + word(keys[1]);
    char separator = ':';
    for (const auto &key : keys.subspan(2)) {
        if (key.get(technique) != 0) {
            text += separator + std::string(key.name) + "=" + word(key);
            separator = ',';
        }
    }
    return text;
}

Technique nearest_valid(Technique technique) {
    for (const auto &key : technique_keys().subspan(2)) {
        if (!key_applies(key, technique)) {
            key.set(technique, 0);
        }
    }
    if (why_refused(technique)) {
        technique.attenuation = AttenuationAt::exact;
    }
    return technique;
}

} // namespace sandbox
