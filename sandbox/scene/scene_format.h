#pragma once

#include "scene/light_kind.h"
#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

/// The scene format, once: every key with its member, range, label, text and rules. Reading, checking, writing, --set,
/// the JSON schema and the window's controls are all made from these tables; defaults are those of scene.h's structs.
namespace sandbox {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double most_objects = 10'000; ///< of a scene
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// The usual part of a range, over which a slider runs, and how its numbers are printed.
struct Slider {
    double low = 0;
    double high = 1;
    const char *format = "%.3g"; ///< as printf takes it
    bool logarithmic = false;
};

/// What the numbers of a key may be (each component of a vector; the length of a list), and how a control shows them.
struct Range {
    double low = -unlimited;
    double high = unlimited;
    bool above_low = false;        ///< low itself is refused
    double or_exactly = no_number; ///< one more number that is accepted
    bool a_direction = false;      ///< a vector that is not (0, 0, 0)
    bool a_color = false;          ///< linear RGB
    Slider slider{};
    std::string_view unit{};
};

constexpr Range any{};
constexpr Range linear_rgb{.low = 0, .high = 1e6, .a_color = true};
constexpr Range intensity{.low = 0, .high = 1e6, .slider = {0, 2, "%.3f"}};
constexpr Range coordinate{.low = -1e9, .high = 1e9, .slider = {-10, 10, "%.2f"}, .unit = "units"};
constexpr Range camera_coordinate{.low = -1e10, .high = 1e10, .unit = "units"}; // around all that has coordinates
constexpr Range direction{.low = -1e9, .high = 1e9, .a_direction = true, .slider = {-1, 1, "%.2f"}};
constexpr Range rotation{.low = -1e9, .high = 1e9, .slider = {-180, 180, "%.1f"}, .unit = "degrees"};
constexpr Range scale_factor{.low = -1e15, .high = 1e15, .slider = {0, 3}};
constexpr Range positive_length{.low = 0, .high = 1e9, .above_low = true, .slider = {0.05, 5}, .unit = "units"};
constexpr Range clip_distance{.low = 0, .high = 1e15, .above_low = true, .unit = "units"};
constexpr Range view_angle{.low = 0, .high = 179, .above_low = true, .slider = {10, 120, "%.1f"}, .unit = "degrees"};
constexpr Range cone_angle{.low = 0, .high = 90, .or_exactly = 180, .slider = {0, 90, "%.1f"}, .unit = "degrees"};
constexpr Range spot_exponent{.low = 0, .high = 1e5, .slider = {0, 128, "%.4g"}};
constexpr Range shininess{.low = 0, .high = 1e7, .slider = {1, 1e4, "%.4g", true}};
constexpr Range exponent_scale{.low = 0, .high = 16, .above_low = true, .slider = {0.25, 8, "%.3g", true}};
constexpr Range repeats{.low = 0, .high = 1e6, .above_low = true, .slider = {0.25, 16, "%.3g", true}};
constexpr Range coefficient(std::string_view unit) {
    return {.low = 0, .high = 1e9, .slider = {0, 2, "%.4g"}, .unit = unit};
}
constexpr Range count(double low, double high, double usual_high) {
    return {.low = low, .high = high, .slider = {low, usual_high, "%.0f", true}};
}

/// The number nearest to `value` that a key takes; from a control that cannot refuse.
constexpr double nearest_accepted(double value, const Range &range) {
    constexpr double least_step = 1e-6; // above a low that is itself refused
    return value == range.or_exactly ? value
                                     : std::clamp(value, range.low + (range.above_low ? least_step : 0), range.high);
}

/// The part of the lighting equation that reads a key: where no light or model has that part, the key has no effect.
enum class Term { any, light, highlight, blinn_highlight };

template <class T> constexpr bool never(const T &) { return false; }
template <class T> constexpr bool always(const T &) { return true; }

/// When a file must hold a key, when anything reads it, and what people call it.
template <class T> struct Rules {
    bool (*needed)(const T &) = never<T>; ///< asked when the keys before it have been read
    bool (*used)(const T &) = always<T>;
    Term term = Term::any;
    std::string_view label{}; ///< of the control, without the unit; empty: the key
};

template <class T, class M> struct Field {
    std::string_view key;
    M T::*member;
    Range range;
    std::string_view doc;
    Rules<T> rules;
    bool has_control;
};

/// A key without a control, or whose control a panel makes by itself.
template <class T, class M>
constexpr Field<T, M> field(std::string_view key, M T::*member, Range range, std::string_view doc,
                            Rules<T> rules = {}) {
    return {key, member, range, doc, rules, false};
}
/// A key whose control is made from this row.
template <class T, class M>
constexpr Field<T, M> control(std::string_view key, M T::*member, Range range, std::string_view doc,
                              Rules<T> rules = {}) {
    rules.label = rules.label.empty() ? key : rules.label;
    return {key, member, range, doc, rules, true};
}

constexpr bool has_checker(const Material &material) { return material.checker.has_value(); }
constexpr bool has_texture(const Material &material) { return !material.texture.empty(); }
constexpr bool has_surface_colors(const Material &m) { return m.checker || has_texture(m); }

template <class... Fields> struct Format {
    std::string_view name; ///< as messages call it
    std::string_view doc;
    std::tuple<Fields...> fields;
};
template <class... Fields>
constexpr Format<Fields...> make_format(std::string_view name, std::string_view doc, Fields... fields) {
    return {name, doc, {fields...}};
}

/// The words of an enumeration 0, 1, ... in the file.
template <class E> inline constexpr auto words_of = nullptr;
template <> inline constexpr std::array<std::string_view, 2> words_of<Projection>{"perspective", "orthographic"};
template <> inline constexpr std::array<std::string_view, 2> words_of<ColorSpace>{"linear", "srgb"};
template <> inline constexpr std::array<std::string_view, 2> words_of<MaterialsOf>{"scene", "file"};
template <class E>
concept HasWords = !std::is_null_pointer_v<std::remove_cv_t<decltype(words_of<E>)>>;

/// The table of every struct that is a JSON object in the file.
template <class T> inline constexpr auto format_of = nullptr;
template <class T>
concept HasFormat = !std::is_null_pointer_v<std::remove_cv_t<decltype(format_of<T>)>>;

template <>
inline constexpr auto format_of<Attenuation> = make_format(
    "attenuation", "Light weakens as 1 / (constant + linear d + quadratic d^2), d the distance in world units.",
    control("constant", &Attenuation::constant, coefficient(""), "The constant coefficient."),
    control("linear", &Attenuation::linear, coefficient("1/unit"), "The coefficient of d, per world unit."),
    control("quadratic", &Attenuation::quadratic, coefficient("1/unit\xC2\xB2"),
            "The coefficient of d^2, per square world unit."));

template <>
inline constexpr auto format_of<Light> = make_format(
    "light", "A light. Keys that its type does not use are kept, so that switching the type back loses nothing.",
    field("type", &Light::type, any, "What kind of light this is.", {.needed = always<Light>}),
    field("enabled", &Light::enabled, any, "false: the light counts as absent."),
    control("color", &Light::color, linear_rgb, "Linear RGB; multiplies all three intensities.", {.label = "colour"}),
    control("ambient", &Light::ambient, intensity, "Ambient intensity, times color."),
    control("diffuse", &Light::diffuse, intensity, "Diffuse intensity, times color."),
    control("specular", &Light::specular, intensity, "Specular intensity, times color.", {.term = Term::highlight}),
    control("attenuate_ambient", &Light::attenuate_ambient, any, "Distance and cone weaken the ambient term, too.",
            {.used = has_position, .label = "attenuate ambient"}),
    control("position", &Light::position, coordinate, "Where a positional light is, in world space.",
            {.needed = has_position, .used = has_position}),
    control("direction", &Light::direction, direction, "The way light travels; need not have length 1.",
            {.needed = has_direction, .used = uses_direction}),
    control("attenuation", &Light::attenuation, any, "How a positional light weakens with distance.",
            {.used = has_position, .label = "Attenuation over the distance d"}),
    control("cutoff_degrees", &Light::cutoff_degrees, cone_angle, "Half angle of a spot light's cone; 180: no cone.",
            {.used = has_cone, .label = "cutoff"}),
    control("inner_cutoff_degrees", &Light::inner_cutoff_degrees, cone_angle,
            "Where the cone's soft edge begins, at most cutoff_degrees (the default: a hard edge).",
            {.used = has_cone, .label = "inner cutoff"}),
    control("exponent", &Light::exponent, spot_exponent,
            "Light weakens away from the cone's axis as cos(angle) to this power.",
            {.used = has_cone, .label = "spot exponent"}));

template <>
inline constexpr auto format_of<Camera> = make_format(
    "camera", "Where the scene is seen from.",
    field("position", &Camera::position, camera_coordinate, "The eye, in world space."),
    field("target", &Camera::target, camera_coordinate, "What it looks at; not the eye itself."),
    field("up", &Camera::up, direction, "Which way is up in the picture."),
    field("projection", &Camera::projection, any,
          "orthographic: what is far looks as large as what is near, and V is the same at every point."),
    control("fov_y_degrees", &Camera::fov_y_degrees, view_angle,
            "The vertical field of view of a perspective camera; the window widens that of a narrow picture.",
            {.used = is_perspective, .label = "field of view"}),
    control("height", &Camera::height, positive_length,
            "How much of the world an orthographic picture shows from its bottom to its top; the wheel changes it.",
            {.needed = is_orthographic, .used = is_orthographic}),
    field("near", &Camera::near_plane, clip_distance, "Nothing nearer is drawn, in world units."),
    field("far", &Camera::far_plane, clip_distance, "Nothing farther is drawn; above near."));

template <>
inline constexpr auto format_of<Transform> = make_format(
    "transform",
    "From object to world space: scale, then rotate about the fixed axes (x, then y, then z), then translate.",
    control("translate", &Transform::translate, coordinate, "In world units.", {.label = "move"}),
    control("rotate_degrees", &Transform::rotate_degrees, rotation, "About the x, y and z axis.", {.label = "turn"}),
    control("scale", &Transform::scale, scale_factor, "Along the object's own axes; 0 and negative are allowed."));

template <>
inline constexpr auto format_of<SphereShape> =
    make_format("sphere", "A sphere about the origin, its poles on the y axis.",
                control("radius", &SphereShape::radius, positive_length, "In object units."),
                control("rings", &SphereShape::rings, count(2, 2048, 256), "Bands of latitude."),
                control("segments", &SphereShape::segments, count(3, 2048, 256), "Slices of longitude."));

template <>
inline constexpr auto format_of<BoxShape> =
    make_format("box", "A box about the origin.",
                control("size", &BoxShape::size, positive_length, "Lengths of its edges along x, y and z."),
                control("divisions", &BoxShape::divisions, count(1, 512, 64), "Squares along each edge of each face."));

template <>
inline constexpr auto format_of<PlaneShape> =
    make_format("plane", "A rectangle in y = 0 about the origin, facing +y.",
                control("size", &PlaneShape::size, positive_length, "Lengths along x and z."),
                control("divisions", &PlaneShape::divisions, count(1, 1024, 128), "Squares along each edge."));

template <>
inline constexpr auto format_of<CylinderShape> =
    make_format("cylinder", "A cylinder about the y axis, centred on the origin.",
                control("radius", &CylinderShape::radius, positive_length, "In object units."),
                control("height", &CylinderShape::height, positive_length, "In object units."),
                control("segments", &CylinderShape::segments, count(3, 2048, 256), "Slices around the axis."),
                control("rings", &CylinderShape::rings, count(1, 2048, 64), "Bands along the axis."),
                control("caps", &CylinderShape::caps, any, "Closes its ends."));

template <>
inline constexpr auto format_of<TorusShape> = make_format(
    "torus", "A torus about the y axis, centred on the origin.",
    control("radius", &TorusShape::radius, positive_length, "From the centre to the middle of the tube."),
    control("tube_radius", &TorusShape::tube_radius, positive_length, "In object units.", {.label = "tube radius"}),
    control("rings", &TorusShape::rings, count(3, 2048, 256), "Steps around the axis."),
    control("segments", &TorusShape::segments, count(3, 2048, 256), "Steps around the tube."));

template <>
inline constexpr auto format_of<ObjShape> = make_format(
    "obj", "A model read from a Wavefront OBJ file.",
    field("obj", &ObjShape::path, any, "Path, relative to the scene file; a bare name may be a built-in model.",
          {.needed = always<ObjShape>}),
    field("usemtl", &ObjShape::usemtl, any,
          "Only the faces under this usemtl of the file; \"\": those before any. Absent: all faces."));

template <>
inline constexpr auto format_of<Checker> = make_format(
    "checker", "Cubic cells of two colours in object space, across the mesh's bounding cube about its origin.",
    control("cells", &Checker::cells, count(1, 1024, 32), "Cells along each axis."),
    control("colors", &Checker::colors, linear_rgb, "The two colours, linear RGB.", {.label = "colour"}));

template <>
inline constexpr auto format_of<Material> = make_format(
    "material", "How the surface answers light; colours are linear RGB.",
    control("ambient", &Material::ambient, linear_rgb, "Share of ambient light returned."),
    control("diffuse", &Material::diffuse, linear_rgb, "Share of diffuse light returned.", {.term = Term::light}),
    control("specular", &Material::specular, linear_rgb, "Share of specular light returned.",
            {.term = Term::highlight}),
    control("emission", &Material::emission, linear_rgb, "Light of its own."),
    control("shininess", &Material::shininess, shininess,
            "The exponent of the highlight: a larger one makes it smaller and sharper.",
            {.term = Term::highlight, .label = "shininess n"}),
    field("texture", &Material::texture, any,
          "A PNG or JPEG file, relative to the scene file; a bare name may be a built-in texture."),
    control("texture_color_space", &Material::texture_color_space, any,
            "linear: the texture's numbers are light; srgb: they are decoded by the sRGB curve, as photographs need.",
            {.used = has_texture, .label = "texture's numbers"}),
    control("texture_repeat", &Material::texture_repeat, repeats,
            "How often the texture repeats where texture coordinates run from 0 to 1, along each.",
            {.used = has_texture, .label = "texture's repeats"}),
    control("texture_modulates_specular", &Material::texture_modulates_specular, any,
            "The texture (or checker) colours the highlight, too.",
            {.used = has_surface_colors, .term = Term::highlight, .label = "surface colours the highlight"}),
    field("checker", &Material::checker, any, "Colours by object-space position; excludes texture.",
          {.used = has_checker}));

template <>
inline constexpr auto format_of<Object> = make_format(
    "object", "A mesh, where it stands and what it is made of.",
    field("name", &Object::name, any, "What panels and messages call it."),
    field("mesh", &Object::mesh, any, "Its shape.", {.needed = always<Object>}),
    field("transform", &Object::transform, any, "Where it stands."),
    field("material", &Object::material, any, "What it is made of."),
    field("materials", &Object::materials, any,
          "file: the materials of the OBJ file's own libraries; reading puts an object for "
          "each in this one's place. What they leave open is as `material` says."),
    control("two_sided", &Object::two_sided, any,
            "Turns the normal where a triangle shows its back, so that both sides are lit.", {.label = "two-sided"}));

template <>
inline constexpr auto
    format_of<View> = make_format("view", "A camera with a name.",
                                  field("name", &View::name, any, "What --view takes.", {.needed = always<View>}),
                                  field("camera", &View::camera, any, "Its camera.", {.needed = always<View>}));

template <>
inline constexpr auto format_of<Opening> =
    make_format("opening", "How the window shows the scene that it opens; commands take no notice.",
                field("left", &Opening::left, any, "The technique of A, such as per-vertex/phong."),
                field("right", &Opening::right, any, "The technique of B, such as per-pixel/phong."),
                field("layout", &Opening::layout, any, "single, side-by-side, wipe, difference or three-up."));

template <>
inline constexpr auto format_of<Scene> = make_format(
    "scene", "A scene of Shading Sandbox.", field("name", &Scene::name, any, "A title."),
    field("description", &Scene::description, any, "What there is to see."),
    field("source", &Scene::source, any, "The document that the scene reproduces."),
    field("camera", &Scene::camera, any, "Where the scene is seen from."),
    control("background", &Scene::background, linear_rgb, "Linear RGB where there is no object."),
    control("ambient", &Scene::ambient, linear_rgb, "Ambient light of no light in particular, linear RGB."),
    control("blinn_exponent_scale", &Scene::blinn_exponent_scale, exponent_scale,
            "Blinn-Phong's exponent is this times the shininess n; 4 matches Phong's highlights to 0.004 near "
            "normal incidence for n >= 32, and not at grazing angles (0.84 apart on a floor).",
            {.term = Term::blinn_highlight, .label = "Blinn n / n"}),
    field("lights", &Scene::lights, {.low = 0, .high = 64}, "At most 64."),
    field("objects", &Scene::objects, {.low = 0, .high = most_objects}, "What is lit; at most 10000."),
    field("views", &Scene::views, any, "Named cameras."),
    field("compare", &Scene::compare, any, "What the window shows of the scene when it opens."));

/// Calls f(field) for every field of T, in the order of the file.
template <class T, class F> constexpr void for_each_field(F &&f) {
    std::apply([&](const auto &...fields) { (f(fields), ...); }, format_of<T>.fields);
}

/// Calls f(std::type_identity<S>{}) for every shape.
template <class F> constexpr void for_each_shape(F &&f) {
    [&]<class... S>(std::type_identity<std::variant<S...>>) {
        (f(std::type_identity<S>{}), ...);
    }(std::type_identity<Shape>{});
}

} // namespace sandbox
