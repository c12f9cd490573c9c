#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// What is lit: exactly what a scene file says, with its defaults. World space, linear RGB, degrees.
/// Ranges are those of the scene file (scene_format.h holds the table).
namespace sandbox {

enum class LightType { directional, point, spot };

/// 1 / (constant + linear d + quadratic d^2), d the distance in world units.
struct Attenuation {
    double constant = 1;
    double linear = 0;
    double quadratic = 0;
    bool operator==(const Attenuation &) const = default;
};

struct Light {
    LightType type = LightType::point;
    bool enabled = true; ///< a light switched off counts as absent
    glm::dvec3 color{1};
    double ambient = 0;
    double diffuse = 1;
    double specular = 1;
    bool attenuate_ambient = false;
    glm::dvec3 position{0};           ///< of a positional light (light_kind.h)
    glm::dvec3 direction{0, -1, 0};   ///< the way light travels; not necessarily unit
    Attenuation attenuation;          ///< of a positional light
    double cutoff_degrees = 30;       ///< half angle of a spot's cone, [0, 90], or 180: no cone
    double inner_cutoff_degrees = 30; ///< <= cutoff_degrees; equal: a hard edge
    double exponent = 0;              ///< of the cone
    bool operator==(const Light &) const = default;
};

enum class Projection { perspective, orthographic };

struct Camera {
    glm::dvec3 position{0, 1, 6};
    glm::dvec3 target{0};
    glm::dvec3 up{0, 1, 0};
    double fov_y_degrees = 45;
    double near_plane = 0.1;
    double far_plane = 100;
    Projection projection = Projection::perspective;
    double height = 0; ///< of what an orthographic picture shows, world units, fov_y_degrees at its default; else 0
    /// Moves the picture by so much (x to the right, y up, the whole picture is 2 wide and high): a sub-pixel sample's.
    /// Not in a scene's file.
    glm::dvec2 picture_shift{0};
    bool operator==(const Camera &) const = default;
};

constexpr bool is_orthographic(const Camera &camera) { return camera.projection == Projection::orthographic; }
constexpr bool is_perspective(const Camera &camera) { return !is_orthographic(camera); }

/// world = T Rz Ry Rx S p
struct Transform {
    glm::dvec3 translate{0};
    glm::dvec3 rotate_degrees{0};
    glm::dvec3 scale{1};
    bool operator==(const Transform &) const = default;
};

struct SphereShape {
    double radius = 1;
    int rings = 32;
    int segments = 64;
    bool operator==(const SphereShape &) const = default;
};
struct BoxShape {
    glm::dvec3 size{1};
    int divisions = 1;
    bool operator==(const BoxShape &) const = default;
};
struct PlaneShape {
    glm::dvec2 size{2};
    int divisions = 1;
    bool operator==(const PlaneShape &) const = default;
};
struct CylinderShape {
    double radius = 0.5;
    double height = 1;
    int segments = 64;
    int rings = 1;
    bool caps = true;
    bool operator==(const CylinderShape &) const = default;
};
struct TorusShape {
    double radius = 1;
    double tube_radius = 0.4;
    int rings = 64;
    int segments = 32;
    bool operator==(const TorusShape &) const = default;
};
struct Mesh;
struct ObjShape {
    std::string path; ///< absolute once read
    /// Only the faces under this `usemtl` of the file; "": those before any. None: all faces.
    std::optional<std::string> usemtl = std::nullopt;
    /// Of a file that was read for its scene to be made, so that it is read once; else null. Not in a scene's file.
    std::shared_ptr<const Mesh> mesh = nullptr;
    bool operator==(const ObjShape &other) const { return path == other.path && usemtl == other.usemtl; }
};
using Shape = std::variant<SphereShape, BoxShape, PlaneShape, CylinderShape, TorusShape, ObjShape>;

/// Colours by object-space position: cells per axis across the mesh's bounding cube about its origin
/// (half edge R = the largest |coordinate| of the mesh); colors[(i + j + k) mod 2], i = floor((x + R) cells / 2R),
/// clamped to [0, cells - 1].
struct Checker {
    int cells = 8;
    std::array<glm::dvec3, 2> colors{glm::dvec3{1, 1, 1}, glm::dvec3{0.8, 0.1, 0.1}};
    bool operator==(const Checker &) const = default;
};

/// What a texture's numbers mean: light itself, or light encoded by the sRGB curve.
enum class ColorSpace { linear, srgb };

struct Material {
    glm::dvec3 ambient{1};
    glm::dvec3 diffuse{1};
    glm::dvec3 specular{1};
    glm::dvec3 emission{0};
    double shininess = 32;
    std::string texture; ///< empty: none; a built-in name, or an absolute path once read
    bool texture_modulates_specular = true;
    std::optional<Checker> checker; ///< excludes texture
    ColorSpace texture_color_space = ColorSpace::linear;
    glm::dvec2 texture_repeat{1}; ///< multiplies texture coordinates
    bool operator==(const Material &) const = default;
};

/// Where a model's materials come from.
enum class MaterialsOf { scene, file };

struct Object {
    std::string name;
    Shape mesh;
    Transform transform;
    Material material;
    bool two_sided = false; ///< N turned where a triangle shows its back
    /// `file`: reading the scene puts one object for each material of the OBJ in this one's place.
    MaterialsOf materials = MaterialsOf::scene;
    bool operator==(const Object &) const = default;
};

struct View {
    std::string name;
    Camera camera;
    bool operator==(const View &) const = default;
};

/// How the window shows a scene that it opens: techniques and a layout, in the words of the command line, for this room
/// knows neither (opening_view() reads them). Empty: as the window has it.
struct Opening {
    std::string left, right, layout;
    bool operator==(const Opening &) const = default;
};

/// Where bare names of a file were looked for before the built-in ones, for messages; empty: nowhere. Not in a scene's
/// file: two scenes that differ in nothing else are equal.
struct LookedIn {
    std::string folder;
    bool operator==(const LookedIn &) const { return true; }
};

struct Scene {
    std::string name;
    std::string description;
    std::string source; ///< the document a built-in scene reproduces, if any
    Camera camera;
    glm::dvec3 background{0};
    glm::dvec3 ambient{0};
    double blinn_exponent_scale = 1; ///< n_B = scale * shininess under Blinn-Phong
    std::vector<Light> lights;       ///< at most 64
    std::vector<Object> objects;
    std::vector<View> views;
    Opening compare;
    LookedIn looked_in;
    bool operator==(const Scene &) const = default;
};

} // namespace sandbox
