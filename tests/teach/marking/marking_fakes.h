#pragma once

#include "reference/reference.h"
#include "scene/resources.h"
#include "teach/marking/exercise_read.h"
#include "teach/marking/marker.h"
#include "tools/english.h"

#include <functional>
#include <string>

namespace sandbox {

/// An exercise with `terms` in one scene.
inline Exercise small_exercise(const std::string &terms, const std::string &target = "per-pixel/phong",
                               const std::string &scenes = R"([{"name": "lamp", "scene": "point-light"}])") {
    const Assets assets("assets");
    return parse_exercise(R"({"title": "T", "task": "Do it.", "target": ")" + target +
                              R"(", "size": "48x36", "scenes": )" + scenes + R"(, "terms": )" + terms + "}",
                          "small.json", {}, assets, english);
}

/// Answers in place of own text: what is drawn of a scene.
using FakeAnswer = std::function<Image(const Scene &, const Technique &, Size)>;

/// The reference draws for the program; `answer` for the student.
struct FakeDraw {
    Resources resources{Assets("assets")};
    ShaderParts parts{Assets("shaders")};
    MarkDraw draw;

    explicit FakeDraw(FakeAnswer answer) {
        draw.parts = &parts;
        draw.trusted.load = [this](const Scene &scene) { return resources.load(scene); };
        draw.trusted.picture = [this](const Scene &scene, const Technique &technique, Size size, bool) {
            Technique known = technique;
            if (known.model == Model::own) {
                return Frame{Image(size, glm::vec4(7)), {}, 0}; // no line explains anything
            }
            known.program = Program::specialised;
            return to_frame(render_reference(scene, resources.load(scene), known, size));
        };
        draw.own = [answer](const Scene &scene, const Technique &technique, Size size, bool) {
            return Frame{answer(scene, technique, size), {}, 0};
        };
    }
    FakeDraw(const FakeDraw &) = delete;
    FakeDraw &operator=(const FakeDraw &) = delete;

    Image truth(const Scene &scene, const std::string &technique, Size size) {
        return to_frame(render_reference(scene, resources.load(scene), parse_technique(technique), size)).color;
    }
};

} // namespace sandbox
