#pragma once

#include "measure/diagnosis/levels.h"
#include "scene/scene.h"

#include <string>
#include <vector>

/// What people do otherwise without a fault of shading: how numbers are written, which light there is.
namespace sandbox {

struct Convention {
    std::string name;  ///< for programs: "display=srgb", "factor=0.7", "lights[1]=0", "flipped"
    std::string words; ///< for people: "every colour is 0.7 times the scene's"
    bool operator==(const Convention &) const = default;
};

/// Every reading of a picture's file, the plain one first.
std::vector<Reading> all_readings(bool bytes);
std::vector<Convention> conventions_of(const Reading &reading);

/// A scene that was changed by conventions.
struct Edit {
    Scene scene;
    std::vector<Convention> conventions;
};
/// What is left out or done as other programs do: attenuation, cones, ambient light that fades with distance.
std::vector<Edit> scene_edits(const Scene &scene);
/// Every exponent of a material times `factor`.
Edit with_exponents(const Scene &scene, double factor);

/// Parts of the light that are proportional to one factor each: the picture is what `rest` draws, plus the factors
/// times what `parts` draw.
struct LinearParts {
    Scene rest;
    std::vector<Scene> parts;
    std::vector<std::string> names; ///< of the parts: "factor"; "ambient", "diffuse", "specular"; "lights[0]", ...
};
/// All light at once, term by term, light by light; parts that are dark are left out.
std::vector<LinearParts> linear_parts(const Scene &scene);
/// The scene with the parts times `factors`, those that are not 1 told.
Edit with_factors(const Scene &scene, const LinearParts &parts, const std::vector<double> &factors);
/// A factor as people choose them: rounded to a whole number, over `digits`; not below 0.
double plain_factor(double factor, double digits);

} // namespace sandbox
