#pragma once

#include "measure/diagnosis/diagnosis.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <cstdint>
#include <string>

namespace sandbox {

/// Own shading that is right, written otherwise than the textbook writes it.
struct OwnRewrite {
    std::string scene_name; ///< of a built-in scene
    Scene scene;            ///< that scene, or one with stiff highlights
    Technique truth;        ///< flat, per-vertex or per-pixel, without faults
    bool given = false;     ///< is the model told, or the frequency alone?
    std::string text;
};

/// One of many shapes, the same for a seed on every machine: sums in other orders, half and mirrored vectors by other
/// roads, loops backwards, unrolled or in two passes, functions, view space, vectors made unit twice, ...
OwnRewrite own_rewrite(std::uint32_t seed);

/// As `diagnose --own` diagnoses it.
Diagnosis diagnosis_of(const OwnRewrite &rewrite, const DiagnosisDraw &draw, Size size);

/// Is it called anything but right, here or in the proposed scene?
bool is_accused(const Diagnosis &diagnosis, const OwnRewrite &rewrite);

/// The text for a scene and a model.
std::string rewritten_lighting(std::uint32_t seed, const Scene &scene, Model model);

} // namespace sandbox
