#include "measure/stability/cases.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace sandbox::stability {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// A sphere seen so near its highlight that the picture spans a few of the highlight's widths, whatever n is.
Scene zoomed_highlight(double n, bool directional) {
    Scene scene = scene_of(SphereShape{1, 32, 64}, {});
    scene.camera.position = {0, 0, 5};
    const double angle = 13 * (2 * std::numbers::pi / 64); // at a vertex on the equator: the mesh lies on the sphere
    const glm::dvec3 p(std::cos(angle), 0, std::sin(angle));
    const glm::dvec3 v = glm::normalize(scene.camera.position - p);
    const glm::dvec3 l = 2 * glm::dot(v, p) * p - v;
    scene.camera.target = p;
    // f^n falls to 1/e at sqrt(2 / n) between N and H; one radian of N is one unit of length, 4 from the eye.
    scene.camera.fov_y_degrees = n > 0 ? std::min(45.0, degrees * 2.5 / std::sqrt(n)) : 45;
    scene.lights = {directional ? directional_light(-l) : point_light(p + 3.0 * l)};
    scene.lights[0].diffuse = 0.1;
    scene.objects[0].material.shininess = n;
    return scene;
}

/// A floor seen and lit at `elevation` degrees from opposite sides: L + V nearly cancels.
Scene grazing_highlight(double n, double elevation) {
    Scene scene = scene_of(PlaneShape{{4, 4}, 8}, {});
    const double angle = elevation / degrees;
    const glm::dvec3 v(0, std::sin(angle), std::cos(angle));
    scene.camera.position = 3.0 * v;
    scene.camera.fov_y_degrees = std::min(20.0, degrees * 8 / std::sqrt(n));
    scene.lights = {directional_light({0, -v.y, v.z})};
    scene.lights[0].diffuse = 0.1;
    scene.objects[0].material.shininess = n;
    return scene;
}

std::string power_of_ten(double n) { return "1e" + std::to_string(static_cast<int>(std::lround(std::log10(n)))); }

StabilityCase stiff_case(double n, const std::string &model, const Scene &scene, const std::string &where) {
    StabilityCase one;
    one.name = "exponent-" + power_of_ten(n) + "-" + model + "-" + where;
    one.group = "exponent";
    one.symptom = "The highlight is ragged or wrong by many levels, and at n = 1e7 brighter than the light.";
    one.cause =
        "The relative error of c^n is n times that of c, and a float32 c near 1 carries 6e-8; N.H rounds above 1.";
    one.source = "float32 against double over 400,000 random directions: one 8-bit level is passed near n = 1e4.";
    one.scene = scene;
    one.techniques = techniques({("per-pixel/" + model).c_str(), ("per-pixel/" + model + ":program=full").c_str(),
                                 ("hybrid/" + model).c_str()});
    one.textbook = parse_technique("per-pixel/" + model + ":power=textbook");
    one.bound = one_level;
    return one;
}

StabilityCase flat_case(const std::string &model) {
    StabilityCase one;
    one.name = "exponent-0-" + model;
    one.group = "exponent";
    one.symptom = "Holes or black rings where the highlight's cosine is 0, on some drivers only.";
    one.cause = "GLSL leaves pow(0, 0) undefined: exp2(0 * log2(0)) is 0 * infinity; one driver gives 0, another 1.";
    one.source = "llvmpipe and softpipe differ here; a slider of the shininess that goes down to 0.";
    one.scene = zoomed_highlight(0, true);
    one.scene.camera.target = {0, 0, 0};
    one.techniques = techniques({("per-pixel/" + model).c_str(), ("per-pixel/" + model + ":program=full").c_str(),
                                 ("per-vertex/" + model).c_str(), ("interpolated-vectors/" + model).c_str()});
    one.bound = one_level;
    return one;
}

} // namespace

std::vector<StabilityCase> exponent_cases() {
    std::vector<StabilityCase> cases;
    for (const std::string model : {"phong", "blinn-phong"}) {
        cases.push_back(flat_case(model));
        for (const double n : {1e3, 1e4, 1e5, 1e6, 1e7}) {
            cases.push_back(stiff_case(n, model, zoomed_highlight(n, false), "point"));
            cases.push_back(stiff_case(n, model, zoomed_highlight(n, true), "directional"));
        }
        for (const double n : {1e5, 1e6, 1e7}) {
            cases.push_back(stiff_case(n, model, grazing_highlight(n, 2), "grazing"));
        }
    }
    return cases;
}

} // namespace sandbox::stability
