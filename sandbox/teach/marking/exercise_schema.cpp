#include "teach/files/text_schema.h"
#include "teach/marking/exercise_format.h"
#include "teach/marking/exercise_read.h"

#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

using Json = nlohmann::ordered_json;

class Schema : public TextSchema<Schema, Json> {
    friend TableSchema<Schema, Json>;

    using TextSchema::type_of;
};

} // namespace

std::string exercise_schema() {
    const Schema schema;
    Json json = schema.document<Exercise>("Shading Sandbox exercise");
    schema.define<ExerciseScene, TermPoints>(json["definitions"]);
    return json.dump(2) + "\n";
}

} // namespace sandbox
