#include "scene/table_schema.h"
#include "teach/claims.h"
#include "teach/lesson_format.h"
#include "teach/lesson_read.h"

#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

using Json = nlohmann::ordered_json;

class Schema : public TableSchema<Schema, Json> {
    friend TableSchema<Schema, Json>;

    using TableSchema::type_of;
    static Json string_or(Json other) { return {{"anyOf", Json::array({{{"type", "string"}}, std::move(other)})}}; }
    Json type_of(const Text &, const Range &) const {
        return string_or({{"type", "object"},
                          {"properties", {{"en", {{"type", "string"}}}, {"zh", {{"type", "string"}}}}},
                          {"additionalProperties", false}});
    }
    Json type_of(const JsonText &, const Range &) const { return string_or({{"type", "object"}}); }
    Json type_of(const Technique &, const Range &) const { return {{"type", "string"}}; }
    Json type_of(Size, const Range &) const { return {{"type", "string"}}; }
    Json type_of(const PictureSource &, const Range &) const {
        return string_or(array_of(number("number", linear_rgb), 3, 3));
    }
};

} // namespace

std::string lesson_schema() {
    const Schema schema;
    Json json = schema.document<Lesson>("Shading Sandbox lesson");
    schema.define<LessonStep, LessonClaim, LookHere, Question>(json["definitions"]);
    json["definitions"]["claim"]["properties"]["metric"]["enum"] = claim_metrics();
    return json.dump(2) + "\n";
}

} // namespace sandbox
