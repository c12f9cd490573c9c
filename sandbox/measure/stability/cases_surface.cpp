#include "measure/stability/cases.h"

#include <glm/geometric.hpp>

namespace sandbox::stability {
namespace {

class Cases {
  public:
    explicit Cases(std::string group) : group_(std::move(group)) {}
    StabilityCase &add(const Scene &scene, const char *name, const char *symptom, const char *cause,
                       const char *source) {
        StabilityCase one;
        one.group = group_;
        one.name = group_ + "-" + name;
        one.symptom = symptom;
        one.cause = cause;
        one.source = source;
        one.scene = scene;
        one.techniques = usual_techniques();
        one.bound = one_level;
        cases_.push_back(one);
        return cases_.back();
    }
    [[nodiscard]] std::vector<StabilityCase> all() { return std::move(cases_); }

  private:
    std::string group_;
    std::vector<StabilityCase> cases_;
};

/// A ball under a point light and a directional one.
Scene ball(const glm::dvec3 &scale) {
    Scene scene = scene_of(SphereShape{}, {point_light({2, 3, 4}), directional_light({1, -1, -1})});
    scene.lights[0].specular = 0.5;
    scene.lights[0].attenuation = {0.2, 0.1, 0.05};
    scene.lights[1].diffuse = 0.3;
    scene.objects[0].transform.scale = scale;
    return scene;
}

/// The ball with every length times s: the same picture.
Scene scaled_ball(double s) {
    Scene scene = ball(glm::dvec3(s));
    scene.camera.position *= s;
    scene.camera.near_plane *= s;
    scene.camera.far_plane *= s;
    Light &light = scene.lights[0];
    light.position *= s;
    light.attenuation = {0.2, 0.1 / s, 0.05 / s / s};
    return scene;
}

Scene moved(Scene scene, const glm::dvec3 &by) {
    scene.camera.position += by;
    scene.camera.target += by;
    for (Light &light : scene.lights) {
        light.position += by;
    }
    for (Object &object : scene.objects) {
        object.transform.translate += by;
    }
    return scene;
}

Scene model(const char *file) {
    Scene scene = ball(glm::dvec3(1));
    scene.objects[0].mesh = ObjShape{file};
    scene.objects[0].transform.rotate_degrees = {20, 30, 0};
    scene.lights[0].ambient = 0.1;
    return scene;
}

} // namespace

std::vector<StabilityCase> transform_cases() {
    Cases cases("transform");
    const char *const inverse =
        "inverse() of a float32 matrix whose determinant is far from 1 loses digits, gives inf or 0.";
    Scene flat = ball({1, 1e-6, 1});
    flat.camera.position = {0, 2, 3};
    cases.add(flat, "scale-1e-6", "The disc is black or speckled.", inverse, "a ball squashed to a decal");
    Scene thin = ball({1e-6, 1, 1});
    thin.objects[0].transform.rotate_degrees = {30, 50, 70};
    cases.add(thin, "scale-1e-6-rotated", "The disc is black or speckled.", inverse, "a decal that was turned");
    Scene needle = ball({1e6, 1, 1});
    cases.add(needle, "scale-1e6", "The long side is lit like the tip.", inverse, "a ball drawn out to a wire");
    Scene huge = ball(glm::dvec3(1e13));
    huge.objects[0].mesh = SphereShape{1e-5, 32, 64}; // 1e8 across its radius
    huge.camera.position = {0, 0, 4e8};
    huge.camera.near_plane = 1e7;
    huge.camera.far_plane = 1e10;
    huge.lights[0].position = {2e8, 3e8, 4e8};
    huge.lights[0].attenuation = {0.2, 1e-9, 0.05e-16};
    cases
        .add(huge, "scale-1e13", "The ball is black, or missing.",
             "The determinant is 1e39, above float32's 3e38: inverse() gives 0 and normalize(0) NaN.",
             "a file in nanometres shown in kilometres")
        .techniques = all_frequencies();
    Scene tiny = ball(glm::dvec3(1e-13));
    tiny.objects[0].mesh = SphereShape{1e9, 32, 64}; // 1e-4
    tiny.camera.position = {0, 0, 4e-4};
    tiny.camera.near_plane = 1e-5;
    tiny.camera.far_plane = 1;
    tiny.lights[0].position = {2e-4, 3e-4, 4e-4};
    tiny.lights[0].attenuation = {0.2, 1e3, 0.05e8};
    cases
        .add(tiny, "scale-1e-13", "The ball is black, or missing.",
             "The determinant is 1e-39, below float32's smallest normal: inverse() gives infinity.",
             "a file in kilometres shown in nanometres")
        .techniques = all_frequencies();
    cases
        .add(scaled_ball(1e-13), "everything-1e-13", "The ball is black, or missing.",
             "Distances of 1e-13, attenuation per unit of 1e8 and above, squares of 1e-26.", "metres for atoms")
        .scene.lights[0]
        .attenuation = {0.2, 1e9, 1e9};
    cases
        .add(scaled_ball(1e-9), "everything-1e-9", "The ball is black, or missing.",
             "Products of three lengths are 1e-27.", "metres for molecules")
        .scene.lights[0]
        .attenuation = {0.2, 1e8, 1e9};
    Scene far_inside = ball(glm::dvec3(1e15));
    far_inside.objects[0].two_sided = true;
    far_inside.camera.near_plane = 1e14;
    far_inside.camera.far_plane = 1e15;
    far_inside.objects[0].mesh = SphereShape{0.5, 32, 64};
    far_inside.lights[0].attenuation = {1, 0, 0};
    cases.add(far_inside, "scale-1e15-from-inside", "Infinity, or nothing.",
              "Squares of 1e15 are 1e30: the fourth power of a length leaves float32's range.", "a sky dome");
    Scene mirrored = ball({-1, 1, 1});
    mirrored.objects[0].transform.rotate_degrees = {0, 30, 20};
    cases
        .add(mirrored, "mirrored", "Lit from the wrong side, or seen from the inside.",
             "det < 0 turns the cofactor normals inwards and the front faces round.",
             "the left shoe made from the right")
        .techniques = all_frequencies();
    Scene mirrored_flat = ball({-2, 1e-3, 1});
    mirrored_flat.camera.position = {0, 2, 3};
    cases.add(mirrored_flat, "mirrored-flattened", "Lit from the wrong side.", "det < 0 and far from 1 at once.",
              "a mirrored decal");
    Scene singular = ball({1, 0, 1});
    singular.objects[0].mesh = PlaneShape{{2, 2}, 4}; // its own plane is all that is left of space
    singular.camera.position = {0, 2, 3};
    cases
        .add(singular, "singular", "The flattened surface is NaN.",
             "det = 0: there is no inverse; the cofactor matrix still has the plane's normal.",
             "planar shadows by a scale of 0")
        .techniques = all_frequencies();
    Scene tall = ball({1, 3, 1e-5});
    tall.objects[0].mesh = TorusShape{1, 0.4, 24, 12};
    tall.lights = {directional_light({0.3, 0.2, 1})};
    tall.lights[0].ambient = 0.2;
    cases.add(
        tall, "thin-and-tall", "The unlit side shines through the lit one.",
        "Front and back lie closer than the depth buffer resolves; the eye is within the object's bounding sphere, "
        "so that back faces were drawn. The box that turns with the object tells better.",
        "fences and screens beside the viewer");
    Scene turned = ball({1, 0.01, 3});
    turned.objects[0].transform.rotate_degrees = {40, 50, 60};
    cases.add(turned, "rotated-uneven", "Normals lean the wrong way.",
              "Only the inverse transpose keeps normals perpendicular; 300 : 1 leaves float32 few digits.",
              "nested rotations and scales of a scene graph");
    return cases.all();
}

std::vector<StabilityCase> vertex_cases() {
    Cases cases("vertices");
    const char *const who = "OBJ files of scanners and exporters";
    cases
        .add(model("opposite-normals.obj"), "opposite-normals", "A dark or white line through the face.",
             "Interpolated between n and -n the normal is 0 half way: normalize(0) is NaN. It then lights nothing.",
             who)
        .techniques = all_frequencies();
    cases
        .add(model("zero-normals.obj"), "zero-normals", "The model is black, or NaN.",
             "vn 0 0 0: normalize(0). Such normals are computed from the faces.", who)
        .techniques = all_frequencies();
    cases.add(model("tiny-normals.obj"), "normals-1e-30", "The model is black, or infinitely bright.",
              "The square of 1e-30 is 0 in float32: the length is 0. Normals are scaled before they are made unit.",
              who);
    cases.add(model("huge-normals.obj"), "normals-1e20", "The model is black.",
              "The square of 1e20 is infinite in float32. Normals are scaled before they are made unit.", who);
    cases.add(model("degenerate.obj"), "degenerate-triangles", "Specks and lines, or NaN on whole faces.",
              "A triangle without area has no normal; computed normals are then 0 / 0. It is dropped on reading.", who);
    Scene near_duplicates = ball({1, 1, 1});
    near_duplicates.objects[0].mesh = SphereShape{1, 512, 512};
    cases.add(near_duplicates, "tiny-triangles", "Specks near the poles.",
              "Triangles a millionth of a pixel wide near the poles.", "meshes finer than the picture");
    Scene coarse = ball({1, 1, 1});
    coarse.objects[0].mesh = SphereShape{1, 2, 3};
    coarse.lights[0].ambient = 0.2;
    cases
        .add(coarse, "coarsest-sphere", "A dark line across each face.",
             "Normals 120 degrees and more apart: interpolation all but cancels them.",
             "the coarsest of levels of detail")
        .techniques = all_frequencies();
    return cases.all();
}

std::vector<StabilityCase> placement_cases() {
    Cases cases("placement");
    const char *const cause =
        "L - P loses 6 cm at 1e6, 1 m at 1e7: float32 has 24 bits. Positions are uploaded from the eye.";
    cases
        .add(moved(ball(glm::dvec3(1)), {1e6, -1e6, 1e6}), "1e6", "Bands, and highlights that jump.", cause,
             "city models in map coordinates")
        .techniques = all_frequencies();
    cases.add(moved(ball(glm::dvec3(1)), {-1e7, 1e7, 1e7}), "1e7", "Facets as large as the object.", cause,
              "geocentric coordinates");
    cases.add(moved(ball(glm::dvec3(1)), {9e8, 9e8, -9e8}), "9e8", "The object is a point, or missing.", cause,
              "the solar system in kilometres");
    Scene own = model("far-origin.obj");
    own.objects[0].transform.rotate_degrees = {0, 0, 0};
    own.objects[0].transform.translate = {-1e6, 0, 0};
    cases.add(own, "mesh-far-from-its-origin", "Torn facets and wrong highlights.",
              "The mesh's own coordinates are 1e6: rounded to float32 before any transform can help.",
              "models exported in map coordinates");
    Scene chequered = own;
    chequered.objects[0].material.checker = Checker{};
    cases.add(chequered, "checker-far-from-its-origin", "Torn facets and wrong highlights.",
              "Cells are counted from the mesh's origin, 1e6 away: whole cells and the rest must be kept apart.",
              "models exported in map coordinates");
    Scene deep = scene_of(PlaneShape{{2e6, 2e6}, 1}, {directional_light({0.3, -1, -0.2}), point_light({0, 2, -5})});
    deep.lights[0].diffuse = 0.5;
    deep.camera.position = {0, 1, 0};
    deep.camera.target = {0, 0.8, -1};
    deep.camera.near_plane = 1e-6;
    deep.camera.far_plane = 1e9;
    deep.objects.push_back({"near", SphereShape{2e-5, 16, 32}, {{2e-5, 1, -1e-4}, {}, glm::dvec3(1)}, {}, false});
    deep.objects.push_back({"far", BoxShape{{3e5, 2e5, 1e5}, 1}, {{-3e5, 1e5, -9e5}, {}, glm::dvec3(1)}, {}, false});
    cases.add(deep, "near-1e-6-far-1e9", "Far surfaces flicker through each other; the near ball is cut.",
              "Depth falls off as near / z: beyond 16 units no float32 depth near 1 is left.",
              "an insect on the lens before a mountain");
    Scene floor = deep;
    floor.objects = {{"floor", PlaneShape{{2e6, 2e6}, 1}, {}, {}, false}};
    floor.camera.near_plane = 0.1;
    floor.camera.far_plane = 1e7;
    cases.add(floor, "one-huge-triangle", "Bands and swimming highlights on a floor of two triangles.",
              "Positions interpolated over 2e6 units carry 0.1 near the eye.", "a ground plane to the horizon");
    Scene beyond = scene_of(PlaneShape{{2e6, 2e6}, 1}, {point_light({2, 3, 4})});
    beyond.objects[0].transform = {{0, -1, 0}, {0, 30, 0}, glm::dvec3(1)};
    beyond.objects.push_back({"ball", SphereShape{}, {}, {}, false});
    beyond.camera.position = {0, 1, 6};
    beyond.camera.near_plane = 0.01;
    beyond.camera.far_plane = 1000;
    cases.add(beyond, "ground-beyond-far", "The ground hides what stands on it.",
              "A vertex at 1e6 has w - z = 2 near = 0.02, where float32 steps by 0.06: its triangle's depth is noise.",
              "a ground plane far larger than the clipped view");
    return cases.all();
}

} // namespace sandbox::stability
