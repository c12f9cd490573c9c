#include "teach/claims.h"
#include "teach/files/text_schema.h"
#include "teach/lesson_format.h"
#include "teach/lesson_read.h"

#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

using Json = nlohmann::ordered_json;

class Schema : public TextSchema<Schema, Json> {
    friend TableSchema<Schema, Json>;

    using TextSchema::type_of;
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
