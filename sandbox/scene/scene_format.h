#pragma once

#include "scene/scene.h"

#include <limits>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

/// The scene format, once: every key with its member, range, text and rule. Reading, checking, writing, --set and the
/// JSON schema are all made from these tables; defaults are those of scene.h's structs.
namespace sandbox {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// What the numbers of a key may be (each component of a vector; the length of a list).
struct Range {
    double low = -unlimited;
    double high = unlimited;
    bool above_low = false;        ///< low itself is refused
    double or_exactly = no_number; ///< one more number that is accepted
    bool a_direction = false;      ///< a vector that is not (0, 0, 0)
};

constexpr Range any{};
constexpr Range intensity{0, 1e6};
constexpr Range coordinate{-1e9, 1e9};
constexpr Range positive_length{0, 1e9, true};
constexpr Range direction{-1e9, 1e9, false, no_number, true};
constexpr Range scale_factor{-1e15, 1e15};
constexpr Range coefficient{0, 1e9};
constexpr Range cone{0, 90, false, 180};
constexpr Range clip_distance{0, 1e15, true};

template <class T, class M> struct Field {
    std::string_view key;
    M T::*member;
    Range range;
    std::string_view doc;
    bool (*needed)(const T &); ///< must the key be there, given the fields before it?
};

template <class T> bool optional_key(const T &) { return false; }
template <class T> bool needed_key(const T &) { return true; }

template <class T, class M>
constexpr Field<T, M> field(std::string_view key, M T::*member, Range range, std::string_view doc,
                            bool (*needed)(const T &) = optional_key<T>) {
    return {key, member, range, doc, needed};
}

/// The words of an enumeration in the file.
struct LightWord {
    LightType type;
    std::string_view word;
};
constexpr LightWord light_words[] = {
    {LightType::directional, "directional"}, {LightType::point, "point"}, {LightType::spot, "spot"}};

/// Specialised for every struct that is a JSON object in the file: `name` as messages call it, `doc`, `fields`.
template <class T> struct Format;
template <class T>
concept HasFormat = requires {
    Format<T>::fields;
};

template <> struct Format<Attenuation> {
    static constexpr std::string_view name = "attenuation";
    static constexpr std::string_view doc =
        "Light weakens as 1 / (constant + linear d + quadratic d^2), d the distance in world units.";
    static constexpr std::tuple fields{
        field("constant", &Attenuation::constant, coefficient, "The constant coefficient."),
        field("linear", &Attenuation::linear, coefficient, "The coefficient of d, per world unit."),
        field("quadratic", &Attenuation::quadratic, coefficient, "The coefficient of d^2, per square world unit.")};
};

constexpr bool has_position(const Light &light) { return light.type != LightType::directional; }
constexpr bool has_direction(const Light &light) { return light.type != LightType::point; }

template <> struct Format<Light> {
    static constexpr std::string_view name = "light";
    static constexpr std::string_view doc =
        "A light. Keys that its type does not use are kept, so that switching the type back loses nothing.";
    static constexpr std::tuple fields{
        field("type", &Light::type, any, "What kind of light this is.", needed_key<Light>),
        field("enabled", &Light::enabled, any, "false: the light counts as absent."),
        field("color", &Light::color, intensity, "Linear RGB."),
        field("ambient", &Light::ambient, intensity, "Ambient intensity, times color."),
        field("diffuse", &Light::diffuse, intensity, "Diffuse intensity, times color."),
        field("specular", &Light::specular, intensity, "Specular intensity, times color."),
        field("attenuate_ambient", &Light::attenuate_ambient, any, "Do distance and cone weaken the ambient term too?"),
        field("position", &Light::position, coordinate, "Point, spot: where it is, in world space.", has_position),
        field("direction", &Light::direction, direction,
              "Directional, spot: the way light travels; need not have length 1.", has_direction),
        field("attenuation", &Light::attenuation, any, "Point, spot: how light weakens with distance."),
        field("cutoff_degrees", &Light::cutoff_degrees, cone, "Spot: half angle of the cone; 180: no cone."),
        field("inner_cutoff_degrees", &Light::inner_cutoff_degrees, cone,
              "Spot: where the soft edge begins, at most cutoff_degrees (the default: a hard edge)."),
        field("exponent", &Light::exponent, {0, 1e5}, "Spot: how fast light weakens away from the axis.")};
};

template <> struct Format<Camera> {
    static constexpr std::string_view name = "camera";
    static constexpr std::string_view doc = "Where the scene is seen from (perspective).";
    static constexpr std::tuple fields{
        field("position", &Camera::position, coordinate, "The eye, in world space."),
        field("target", &Camera::target, coordinate, "What it looks at; not the eye itself."),
        field("up", &Camera::up, direction, "Which way is up in the picture."),
        field("fov_y_degrees", &Camera::fov_y_degrees, {0, 179, true}, "The vertical field of view."),
        field("near", &Camera::near_plane, clip_distance, "Nothing nearer is drawn, in world units."),
        field("far", &Camera::far_plane, clip_distance, "Nothing farther is drawn; above near.")};
};

template <> struct Format<Transform> {
    static constexpr std::string_view name = "transform";
    static constexpr std::string_view doc =
        "From object to world space: scale, then rotate about the fixed axes (x, then y, then z), then translate.";
    static constexpr std::tuple fields{
        field("translate", &Transform::translate, coordinate, "In world units."),
        field("rotate_degrees", &Transform::rotate_degrees, coordinate, "About the x, y and z axis."),
        field("scale", &Transform::scale, scale_factor, "Along the object's own axes; 0 and negative are allowed.")};
};

template <> struct Format<SphereShape> {
    static constexpr std::string_view name = "sphere";
    static constexpr std::string_view doc = "A sphere about the origin, its poles on the y axis.";
    static constexpr std::tuple fields{field("radius", &SphereShape::radius, positive_length, "In object units."),
                                       field("rings", &SphereShape::rings, {2, 2048}, "Bands of latitude."),
                                       field("segments", &SphereShape::segments, {3, 2048}, "Slices of longitude.")};
};

template <> struct Format<BoxShape> {
    static constexpr std::string_view name = "box";
    static constexpr std::string_view doc = "A box about the origin.";
    static constexpr std::tuple fields{
        field("size", &BoxShape::size, positive_length, "Lengths of its edges along x, y and z."),
        field("divisions", &BoxShape::divisions, {1, 512}, "Squares along each edge of each face.")};
};

template <> struct Format<PlaneShape> {
    static constexpr std::string_view name = "plane";
    static constexpr std::string_view doc = "A rectangle in y = 0 about the origin, facing +y.";
    static constexpr std::tuple fields{
        field("size", &PlaneShape::size, positive_length, "Lengths along x and z."),
        field("divisions", &PlaneShape::divisions, {1, 1024}, "Squares along each edge.")};
};

template <> struct Format<CylinderShape> {
    static constexpr std::string_view name = "cylinder";
    static constexpr std::string_view doc = "A cylinder about the y axis, centred on the origin.";
    static constexpr std::tuple fields{
        field("radius", &CylinderShape::radius, positive_length, "In object units."),
        field("height", &CylinderShape::height, positive_length, "In object units."),
        field("segments", &CylinderShape::segments, {3, 2048}, "Slices around the axis."),
        field("rings", &CylinderShape::rings, {1, 2048}, "Bands along the axis."),
        field("caps", &CylinderShape::caps, any, "Are its ends closed?")};
};

template <> struct Format<TorusShape> {
    static constexpr std::string_view name = "torus";
    static constexpr std::string_view doc = "A torus about the y axis, centred on the origin.";
    static constexpr std::tuple fields{
        field("radius", &TorusShape::radius, positive_length, "From the centre to the middle of the tube."),
        field("tube_radius", &TorusShape::tube_radius, positive_length, "In object units."),
        field("rings", &TorusShape::rings, {3, 2048}, "Steps around the axis."),
        field("segments", &TorusShape::segments, {3, 2048}, "Steps around the tube.")};
};

template <> struct Format<ObjShape> {
    static constexpr std::string_view name = "obj";
    static constexpr std::string_view doc = "A model read from a Wavefront OBJ file.";
    static constexpr std::tuple fields{field("obj", &ObjShape::path, any,
                                             "Path, relative to the scene file; a bare name may be a built-in model.",
                                             needed_key<ObjShape>)};
};

template <> struct Format<Checker> {
    static constexpr std::string_view name = "checker";
    static constexpr std::string_view doc =
        "Cubic cells of two colours in object space, across the mesh's bounding cube about its origin.";
    static constexpr std::tuple fields{field("cells", &Checker::cells, {1, 1024}, "Cells along each axis."),
                                       field("colors", &Checker::colors, intensity, "The two colours, linear RGB.")};
};

template <> struct Format<Material> {
    static constexpr std::string_view name = "material";
    static constexpr std::string_view doc = "How the surface answers light; colours are linear RGB.";
    static constexpr std::tuple fields{
        field("ambient", &Material::ambient, intensity, "Share of ambient light returned."),
        field("diffuse", &Material::diffuse, intensity, "Share of diffuse light returned."),
        field("specular", &Material::specular, intensity, "Share of specular light returned."),
        field("emission", &Material::emission, intensity, "Light of its own."),
        field("shininess", &Material::shininess, {0, 1e7}, "The exponent of the highlight."),
        field("texture", &Material::texture, any,
              "A PNG or JPEG file, relative to the scene file; a bare name may be a built-in texture."),
        field("texture_modulates_specular", &Material::texture_modulates_specular, any,
              "Does the texture (or checker) colour the highlight too?"),
        field("checker", &Material::checker, any, "Colours by object-space position; excludes texture.")};
};

template <> struct Format<Object> {
    static constexpr std::string_view name = "object";
    static constexpr std::string_view doc = "A mesh, where it stands and what it is made of.";
    static constexpr std::tuple fields{
        field("name", &Object::name, any, "What panels and messages call it."),
        field("mesh", &Object::mesh, any, "Its shape.", needed_key<Object>),
        field("transform", &Object::transform, any, "Where it stands."),
        field("material", &Object::material, any, "What it is made of."),
        field("two_sided", &Object::two_sided, any, "Turn the normal to the viewer wherever it points away?")};
};

template <> struct Format<View> {
    static constexpr std::string_view name = "view";
    static constexpr std::string_view doc = "A camera with a name.";
    static constexpr std::tuple fields{field("name", &View::name, any, "What --view takes.", needed_key<View>),
                                       field("camera", &View::camera, any, "Its camera.", needed_key<View>)};
};

template <> struct Format<Scene> {
    static constexpr std::string_view name = "scene";
    static constexpr std::string_view doc = "A scene of Shading Sandbox.";
    static constexpr std::tuple fields{
        field("name", &Scene::name, any, "A title."),
        field("description", &Scene::description, any, "What there is to see."),
        field("source", &Scene::source, any, "The document that the scene reproduces."),
        field("camera", &Scene::camera, any, "Where the scene is seen from."),
        field("background", &Scene::background, intensity, "Linear RGB where there is no object."),
        field("ambient", &Scene::ambient, intensity, "Ambient light of no light in particular, linear RGB."),
        field("blinn_exponent_scale", &Scene::blinn_exponent_scale, {0, 16, true},
              "Blinn-Phong raises to this times the shininess; 4 makes its highlights match Phong's."),
        field("lights", &Scene::lights, {0, 64}, "At most 64."),
        field("objects", &Scene::objects, any, "What is lit."),
        field("views", &Scene::views, any, "Named cameras.")};
};

/// Calls f(field) for every field of T, in the order of the file.
template <class T, class F> constexpr void for_each_field(F &&f) {
    std::apply([&](const auto &...fields) { (f(fields), ...); }, Format<T>::fields);
}

/// Calls f(std::type_identity<S>{}) for every shape.
template <class F> constexpr void for_each_shape(F &&f) {
    [&]<class... S>(std::type_identity<std::variant<S...>>) {
        (f(std::type_identity<S>{}), ...);
    }(std::type_identity<Shape>{});
}

} // namespace sandbox
