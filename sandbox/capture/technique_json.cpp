#include "capture/technique_json.h"

#include "shading/own_text.h"

#include <nlohmann/json.hpp>

namespace sandbox {

using nlohmann::ordered_json;

ordered_json technique_json(const Technique &technique) {
    if (!technique.own) {
        return to_string(technique);
    }
    return {{"technique", to_string(technique)}, {"file", technique.own->file}, {"own", technique.own->text}};
}

Technique technique_of(const ordered_json &json) {
    if (!json.is_object()) {
        return parse_technique(json.get<std::string>());
    }
    const OwnShader own(json.at("file").get<std::string>(), json.at("own").get<std::string>());
    return parse_technique_with(own, json.at("technique").get<std::string>());
}

} // namespace sandbox
