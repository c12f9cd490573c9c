#pragma once

#include "image/image.h"
#include "scene/table_schema.h"
#include "shading/technique.h"
#include "teach/files/text.h"

#include <utility>

namespace sandbox {

/// The types that TextReader reads. See TableSchema.
template <class Derived, class Json> class TextSchema : public TableSchema<Derived, Json> {
    using Base = TableSchema<Derived, Json>;

  protected:
    using Base::type_of;
    static Json string_or(Json other) { return {{"anyOf", Json::array({{{"type", "string"}}, std::move(other)})}}; }
    Json type_of(const Text &, const Range &) const {
        return string_or({{"type", "object"},
                          {"properties", {{"en", {{"type", "string"}}}, {"zh", {{"type", "string"}}}}},
                          {"additionalProperties", false}});
    }
    Json type_of(const JsonText &, const Range &) const { return string_or({{"type", "object"}}); }
    Json type_of(const Technique &, const Range &) const { return {{"type", "string"}}; }
    Json type_of(Size, const Range &) const { return {{"type", "string"}}; }
};

} // namespace sandbox
