#pragma once

#include "scene/assets.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The stiff and extreme cases as data: assets/stability/cases/NAME.json, or a file that a teacher wrote.
namespace sandbox {

/// What a bound is a share of.
enum class ErrorUnit {
    linear_color,   ///< 1, a display's white
    brightest_value ///< the largest channel of the reference's compared pixels: for scenes far from a display's range
};
/// As files write it: "linear colour", "brightest value".
std::string_view name_of(ErrorUnit unit);

/// What the textbook's picture is kept in before it is judged.
enum class TextbookTarget {
    float32,
    half ///< values above 65504 become infinite, below 3e-8 they become 0
};

struct StabilityCase {
    std::string name;                   ///< the file's name without .json
    std::string group;                  ///< cases of a group stand together
    std::string symptom, cause, source; ///< the story: what is seen, why, and who meets it
    /// Who or what shows the damage, for a renderer on which the textbook's form stays whole; may be empty.
    std::string seen_on;
    Scene scene;
    std::vector<Technique> techniques; ///< every one must pass; the first is shown
    /// What people write, drawn by the renderer and judged by the first technique's truth, whose frequency and model it
    /// should have. Without it, the textbook is textbook_picture().
    std::optional<Technique> textbook;
    TextbookTarget textbook_target = TextbookTarget::float32;
    double bound = 0; ///< of the largest difference over the compared pixels
    ErrorUnit unit = ErrorUnit::linear_color;
};

/// Reads a case. `text` is a JSON object with the keys
///   group, symptom, cause, source: strings that are not empty; seen_on: the same (default: none);
///   scene: the name of a scene in assets/stability/scenes, a built-in scene, a file, or a scene object;
///   set: a list of PATH=VALUE, as --set takes them, that change the scene (default: none);
///   techniques: a list (default: per pixel by Phong, by Blinn-Phong and by its full program, and per vertex);
///   textbook: a technique (default: none), textbook_target: "float32" or "half" (default: float32), bound: a number >
///   0 (default: 1/255), unit: see name_of (linear colour).
/// `file` is used in messages and gives the case its name; relative paths are looked for in `folder`. Throws
/// InputError.
StabilityCase parse_stability_case(std::string_view text, const std::filesystem::path &file,
                                   const std::filesystem::path &folder, const Assets &assets);

/// The built-in cases in the order of assets/stability/order.json; those that it does not name come last in their
/// group.
std::vector<StabilityCase> stability_cases(const Assets &assets = Assets("assets"));

/// The built-in case of that name, or the case in the file NAME.json. Throws InputError.
StabilityCase open_stability_case(const std::string &name_or_file, const Assets &assets);

} // namespace sandbox
