#include "measure/stability/cases.h"

#include <cmath>
#include <numbers>

namespace sandbox::stability {
namespace {

StabilityCase story(const char *group, const char *name, const char *symptom, const char *cause, const char *source) {
    StabilityCase one;
    one.group = group;
    one.name = std::string(group) + "-" + name;
    one.symptom = symptom;
    one.cause = cause;
    one.source = source;
    one.techniques = usual_techniques();
    one.bound = one_level;
    return one;
}

/// A floor from above, at 45 degrees.
Scene floor_scene(std::vector<Light> lights, int divisions = 8) {
    Scene scene = scene_of(PlaneShape{{4, 4}, divisions}, std::move(lights));
    scene.camera.position = {0, 3, 3};
    return scene;
}

Scene straight_down(std::vector<Light> lights) {
    Scene scene = floor_scene(std::move(lights));
    scene.camera.position = {0, 4, 0};
    scene.camera.up = {0, 0, -1};
    return scene;
}

Light faded(Light light, const Attenuation &attenuation) {
    light.attenuation = attenuation;
    return light;
}

} // namespace

std::vector<StabilityCase> geometry_cases() {
    std::vector<StabilityCase> cases;
    const auto add = [&](const Scene &scene, const char *name, const char *symptom, const char *cause,
                         const char *source) -> StabilityCase & {
        cases.push_back(story("geometry", name, symptom, cause, source));
        cases.back().scene = scene;
        return cases.back();
    };
    add(straight_down({point_light({0, 0, 0})}), "light-on-the-surface", "One black or missing pixel under the light.",
        "L = normalize(0) = NaN where the light touches the surface; L is N there.", "a lamp dragged down to the floor")
        .techniques = all_frequencies();
    add(floor_scene({point_light({0.5, 0, 0.5})}), "light-at-a-vertex",
        "Per vertex, every triangle around one vertex is black.",
        "normalize(0) at that vertex; interpolation spreads it.", "a light placed by snapping to the grid")
        .techniques = all_frequencies();
    Scene inside = scene_of(SphereShape{}, {point_light({0, 0, 0})});
    inside.lights[0].position = {0.3, 0.2, 0.1};
    inside.lights[0].ambient = 0.2;
    inside.camera.position = {0, 0, 0.5};
    inside.camera.target = {0, 0, -1};
    inside.camera.fov_y_degrees = 90;
    inside.objects[0].two_sided = true;
    add(inside, "light-and-eye-inside", "The inside of a ball stays black or is lit from the wrong side.",
        "Normals point outwards; seen from inside, N must be turned to the viewer.", "a lamp inside its shade");
    Scene viewer = inside;
    viewer.camera.position = {0, 1, 0};
    viewer.camera.target = {0, 0, 0.2};
    viewer.camera.near_plane = 1e-3;
    add(viewer, "eye-at-a-vertex", "A fan of black triangles around the eye.",
        "V = normalize(eye - P) = normalize(0) at the vertex where the camera is.", "a camera that walks along a mesh")
        .techniques = all_frequencies();
    Scene opposite = straight_down({directional_light({0, -1, 0})});
    opposite.camera.position = {0, -4, 0};
    add(opposite, "light-behind-the-surface", "One bright or black pixel where light, surface and eye are in line.",
        "H = normalize(L + V) = normalize(0) where L = -V; H is N there.", "a window seen against the sun")
        .techniques = all_frequencies();
    cases.back().scene.lights[0].ambient = 0.25;
    opposite.lights = {point_light({0, 4, 0})};
    add(opposite, "point-behind-the-surface", "One bright or black pixel where lamp, surface and eye are in line.",
        "H = normalize(0) where L = -V.", "a paper lantern");
    const double grazing = 89.9999 * std::numbers::pi / 180;
    add(floor_scene({directional_light({std::sin(grazing), -std::cos(grazing), 0})}), "grazing-light",
        "The floor flickers between lit and dark.", "N.L = 2e-6 is within a few float32 roundings of 0.",
        "sunset over a plain")
        .scene.lights[0]
        .ambient = 0.2;
    Scene low = floor_scene({point_light({0, 1, -1})});
    low.camera.position = {0, 0.02, 2.5};
    low.camera.target = {0, 0, 0.5};
    low.camera.fov_y_degrees = 1;
    add(low, "grazing-eye", "Sparkles near the horizon.",
        "N.V is below 0.02, and the mirrored view is nearly the view itself.", "a fly's view of a table");
    Scene edge = scene_of(SphereShape{1, 64, 128}, {point_light({0, 0, -3})});
    edge.lights[0].ambient = 0.2;
    edge.objects[0].material.shininess = 1000;
    add(edge, "light-behind-the-object", "A broken bright rim around the object.",
        "At the silhouette N.L, N.V and |L + V| are all near 0.", "an eclipse, a rim light");
    return cases;
}

std::vector<StabilityCase> attenuation_cases() {
    std::vector<StabilityCase> cases;
    const auto add = [&](const Scene &scene, const char *name, const char *symptom, const char *cause,
                         const char *source) -> StabilityCase & {
        cases.push_back(story("attenuation", name, symptom, cause, source));
        cases.back().scene = scene;
        cases.back().unit = ErrorUnit::brightest_value;
        return cases.back();
    };
    const char *const floor_cause =
        "1 / (kq d^2) is infinite at d = 0, and infinity * 0 is NaN; the denominator has a floor of 1e-6.";
    add(straight_down({faded(point_light({0, 0, 0}), {0, 0, 1})}), "kc-0-on-the-surface",
        "A white or black pixel at the light.", floor_cause, "\"physically correct\" 1 / d^2, without the 1");
    add(straight_down({faded(point_light({0, 1e-4, 0}), {0, 1, 0})}), "kc-0-near-the-surface",
        "A spot of infinite brightness.", floor_cause, "linear attenuation alone");
    add(floor_scene({faded(point_light({0, 1, 0}), {0, 0, 1e9})}), "kq-1e9", "The picture is black, or NaN.",
        "Values of 1e-9 must survive; float32 has room for them.", "the slider at its end");
    add(floor_scene({faded(point_light({0, 1, 0}), {0, 0, 1e-30})}), "coefficients-1e-30", "The picture is infinite.",
        "1e-30 d^2 is below the denominator's floor: a = 1e6.", "a light meant not to weaken at all, typed as 1e-30");
    add(floor_scene({point_light({6e8, 6e8, 3e8})}), "light-1e9-away", "Nothing is lit, or bands appear.",
        "Squares of 1e9 need 1e18; differences of 1e9 lose everything below 64.", "the sun as a point light");
    add(floor_scene({faded(point_light({6e8, 6e8, 3e8}), {0, 0, 1})}), "light-1e9-away-faded",
        "Nothing is lit, or bands appear.", "1 / d^2 = 1e-18 times colours that make up for it.",
        "the sun as a point light in SI units");
    cases.back().scene.lights[0].diffuse = cases.back().scene.lights[0].specular = 1e6;
    add(floor_scene({faded(point_light({6e8, 6e8, 3e8}), {0, 0, 1e9})}), "light-1e9-away-kq-1e9",
        "The picture is black, or NaN.", "kq d^2 = 1e27 is within float32, d^2 kq computed otherwise may not be.",
        "two sliders at their ends");
    Scene ambient = floor_scene({faded(point_light({0, 0.5, 0}), {0, 0, 1e-7})});
    ambient.lights[0].ambient = 0.5;
    ambient.lights[0].attenuate_ambient = true;
    add(ambient, "ambient-at-the-floor", "Rings where the denominator meets its floor.",
        "The floor must bind all terms of the light alike.", "attenuated ambient light");
    return cases;
}

std::vector<StabilityCase> spot_cases() {
    std::vector<StabilityCase> cases;
    const auto add = [&](const Light &light, const char *name, const char *symptom, const char *cause,
                         const char *source) -> StabilityCase & {
        cases.push_back(story("spot", name, symptom, cause, source));
        cases.back().scene = floor_scene({light});
        cases.back().scene.lights[0].ambient = 0.1;
        return cases.back();
    };
    const glm::dvec3 down(0.1, -1, 0.05);
    const auto soft = [](Light light, double inner, double exponent) {
        light.inner_cutoff_degrees = inner;
        light.exponent = exponent;
        return light;
    };
    add(spot_light({0, 2, 0}, down, 0), "cutoff-0", "The whole floor is lit, or nothing ever is.",
        "cos(0) = 1 and dot(L, D) rounds to 1 or above: a cone of no width must light nothing.",
        "the slider at its end");
    add(spot_light({0, 2, 0}, {0, 0, -1}, 90), "cutoff-90", "A sliver of light behind the lamp.",
        "cos(90 degrees) in float32 is -4.4e-8.", "a lamp on a wall");
    add(soft(spot_light({0, 2, 0}, down, 180), 180, 100), "cutoff-180", "Darkness behind a lamp that has no cone.",
        "cos(180 degrees) = -1 and dot(L, D) rounds below it; the exponent is dropped with the cone.", "OpenGL's rule");
    add(soft(spot_light({0, 2, 0}, down, 30), 30, 0), "inner-equals-outer", "The lit disc is NaN: black or white.",
        "smoothstep and the quotient divide by inner - outer = 0.", "two sliders at one place");
    add(soft(spot_light({0, 2, 0}, down, 90), 90, 0), "exponent-0", "A black line where the cosine is 0.",
        "pow(0, 0) is undefined.", "a cone of 90 degrees with no falloff");
    add(soft(spot_light({0, 2, 0}, down, 60), 60, 128), "exponent-128", "Nothing: it must stay so.", "none",
        "OpenGL's largest spot exponent");
    cases.push_back(story("spot", "exponent-1e5", "The beam is ragged.",
                          "The relative error of c^n is n times that of c.", "a laser"));
    cases.back().scene = straight_down({soft(spot_light({0, 2, 0}, {0, -1, 0}, 30), 20, 1e5)});
    cases.back().scene.camera.fov_y_degrees = 0.6;
    cases.back().scene.lights[0].specular = 0;
    cases.back().techniques = techniques({"per-pixel/lambert", "per-pixel/lambert:program=full"});
    cases.back().textbook = parse_technique("per-pixel/lambert:power=textbook");
    Light narrow = soft(spot_light({0, 2, 0}, {0, -1, 0}, 0.02), 0, 0);
    cases.push_back(story("spot", "narrow-cone", "The soft edge has steps, or is missing.",
                          "Cosines near 1 carry 6e-8 and the whole edge is as wide: sines are needed.", "a pin light"));
    cases.back().scene = straight_down({narrow});
    cases.back().scene.camera.fov_y_degrees = 0.03;
    cases.push_back(story("spot", "narrow-hard-cone", "The disc has a ragged edge or the wrong size.",
                          "cos(0.01 degrees) = 1 - 1.5e-8 is 1 in float32.", "a pin light"));
    cases.back().scene = straight_down({spot_light({0, 2, 0}, {0, -1, 0}, 0.01)});
    cases.back().scene.camera.fov_y_degrees = 1;
    cases.back().techniques = techniques({"per-pixel/blinn-phong", "per-pixel/blinn-phong:program=full"});
    return cases;
}

} // namespace sandbox::stability
