#pragma once

#include "image/image.h"
#include "scene/motion.h"
#include "scene/overlays.h"
#include "scene/scene.h"
#include "shading/technique.h"
#include "teach/files/text.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

/// A lesson: steps of text and picture, each with claims that are measured on the spot. lesson_format.h holds the keys.
namespace sandbox {

/// A picture that a claim is about, or is judged by.
struct PictureSource {
    enum class Kind {
        left,
        right,
        reference, ///< per pixel in double, every fault off, of the other picture's model and mesh
        analytic,  ///< the same on the shapes that the meshes stand for
        twin,      ///< the other picture's technique in double
        textbook,  ///< textbook_picture() of its model
        technique, ///< a technique by name
        color      ///< one colour all over
    };
    Kind kind = Kind::left;
    Technique technique{};
    glm::dvec3 color{0};
};

/// Exactly one of the bounds stands in a claim that is checked. A run time is shown and never checked.
struct LessonClaim {
    Text says; ///< empty: it is said in the words of its metric
    std::string metric;
    PictureSource of;
    std::optional<PictureSource> against; ///< default: the reference
    std::optional<PictureSource> than;    ///< the value is divided by the same figure of this picture
    std::vector<std::string> set;         ///< PATH=VALUE: changes the step's scene
    std::vector<std::string> against_set; ///< ... for `against` alone
    std::optional<glm::dvec4> region;     ///< left, top, right, bottom as shares of the picture
    Size size{320, 240};
    std::vector<double> meshes; ///< mesh factors: the value is the order at which the figure falls
    JsonText motion_json;
    std::string stage;                   ///< "vertex" or "fragment"; empty: both
    std::vector<std::string> has, lacks; ///< words of a GLSL text, in place of a metric
    std::optional<double> below, above, equals, about;
    double within = 0; ///< the factor around `about`, above 1

    Scene scene, against_scene;   ///< the step's, changed by set; and that, changed by against_set
    std::optional<Motion> motion; ///< read from motion_json
    [[nodiscard]] bool checked() const;
};

/// A place to look at: a ring over every view.
struct LookHere {
    glm::dvec2 at{0.5};  ///< shares of a view's width and height, from its upper left corner
    double radius = 0.1; ///< a share of its height
};

struct Question {
    Text asks, answer;
};

/// The layouts of capture/, which this room does not know.
enum class StepLayout { single, side_by_side, wipe, difference, three_up };

/// With what is drawn over every view.
struct LessonStep : Overlays {
    Text title, text;
    JsonText scene_json;                  ///< a name, a path or a scene; absent: the last step's scene
    std::vector<std::string> set;         ///< PATH=VALUE: changes it
    JsonText camera_json;                 ///< a view's name or a camera
    std::optional<Technique> left, right; ///< absent: the last step's; always there once read
    StepLayout layout = StepLayout::side_by_side;
    glm::dvec2 mesh_factors{1}; ///< of left and right
    Display display = Display::linear;
    double exposure = 1, gain = 1;
    std::optional<LookHere> look;
    std::string tab; ///< the key of the window's tab beside the step; empty: none
    std::optional<Question> question;
    bool asserts = true; ///< false: a step that claims nothing
    std::vector<LessonClaim> claims;

    Scene scene; ///< what is shown
};

struct Lesson {
    Text title, about;
    double order = 1000; ///< lessons are listed by it
    Text seen, cure;     ///< of a famous bug: what people saw, and what helped
    std::string source;  ///< ... and where it was told: a project and a number; empty: no bug
    std::vector<LessonStep> steps;

    std::string name; ///< the file's name without .json
    [[nodiscard]] bool is_bug() const { return !source.empty(); }
};

} // namespace sandbox
