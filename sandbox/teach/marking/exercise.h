#pragma once

#include "image/image.h"
#include "scene/scene.h"
#include "shading/technique.h"
#include "teach/files/text.h"
#include "teach/marking/terms.h"

#include <string>
#include <vector>

/// An exercise: what own shading is asked to do, in which scenes, and what each term is worth. exercise_format.h holds
/// the keys.
namespace sandbox {

struct ExerciseScene {
    std::string name;             ///< in sentences; empty: a number
    JsonText scene_json;          ///< a name, a path or a scene; absent: the first one's
    std::vector<std::string> set; ///< PATH=VALUE: changes it
    bool withheld = false;        ///< marked, but not in the student's copy
    bool stiff = false;           ///< for robustness alone

    Scene scene; ///< what is drawn
};

/// What one term is worth.
struct TermPoints {
    MarkTerm term = MarkTerm::diffuse;
    double points = 1;
    double tolerance = 1.0 / 255; ///< of linear light: a level of 8 bits, below which no screen shows an error
};

struct Exercise {
    Text title, about, task;
    double order = 1000;                 ///< exercises are listed by it
    Technique target;                    ///< frequency and model that own shading is held against
    std::vector<std::string> has, lacks; ///< words of an answer's text: that it must use, that it must not
    Size size{160, 120}; ///< of the pictures that are marked; the ones that are shown are twice as large
    std::vector<ExerciseScene> scenes;
    std::vector<TermPoints> terms;

    std::string name; ///< the file's name without .json

    [[nodiscard]] double points() const;
    [[nodiscard]] MarkTerms asked() const; ///< its terms
    [[nodiscard]] const TermPoints *find(MarkTerm term) const;
    /// The first scene, which students see and pictures are of.
    [[nodiscard]] const Scene &shown_scene() const { return scenes.front().scene; }
};

} // namespace sandbox
