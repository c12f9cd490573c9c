#include "scene/scene_schema.h"

#include "scene/scene_json.h"
#include "scene/table_schema.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

class Schema : public TableSchema<Schema, OrderedJson> {
  public:
    friend TableSchema<Schema, OrderedJson>;

  private:
    using TableSchema::type_of;
    OrderedJson type_of(LightType, const Range &) const {
        std::array<std::string_view, light_kinds.size()> types;
        std::ranges::transform(light_kinds, types.begin(), &LightKind::word);
        return words(types);
    }
    OrderedJson type_of(const Shape &, const Range &) const { return reference("mesh"); }
};

/// Which keys a light needs depends on its type; its inner cone's default depends on the outer one.
OrderedJson light_schema() {
    OrderedJson json = Schema().object<Light>();
    json["properties"]["inner_cutoff_degrees"].erase("default");
    json["required"] = OrderedJson::array({"type"});
    for (const LightKind &kind : light_kinds) {
        Light light;
        light.type = kind.type;
        json["allOf"].push_back({{"if", {{"properties", {{"type", {{"const", std::string(kind.word)}}}}}}},
                                 {"then", {{"required", Schema::required_keys(light)}}}});
    }
    return json;
}

/// The two projections say in their own words how much they show.
OrderedJson camera_schema() {
    OrderedJson json = Schema().object<Camera>();
    json["properties"]["height"].erase("default");
    json["if"] = {{"properties", {{"projection", {{"const", "orthographic"}}}}},
                  {"required", OrderedJson::array({"projection"})}};
    json["then"] = {{"required", OrderedJson::array({"height"})}, {"properties", {{"fov_y_degrees", false}}}};
    json["else"] = {{"properties", {{"height", false}}}};
    return json;
}

OrderedJson mesh_schema() {
    OrderedJson json;
    for_each_shape([&]<class S>(std::type_identity<S>) {
        OrderedJson shape = Schema().object<S>();
        if constexpr (!std::is_same_v<S, ObjShape>) {
            shape["properties"]["shape"] = {{"const", std::string(format_of<S>.name)}};
            shape["required"] = OrderedJson::array({"shape"});
        }
        json["oneOf"].push_back(std::move(shape));
    });
    return json;
}

} // namespace

std::string scene_schema() {
    OrderedJson json = Schema().document<Scene>("Shading Sandbox scene");
    OrderedJson &definitions = json["definitions"];
    Schema().define<Attenuation, Object, Transform, Material, Checker, View, Opening>(definitions);
    definitions["camera"] = camera_schema();
    definitions["light"] = light_schema();
    definitions["mesh"] = mesh_schema();
    return print_json(json);
}

} // namespace sandbox
