#include "tools/json_readers.h"

#include "capture/frame_names.h"
#include "capture/grid.h"
#include "capture/sidecar.h"
#include "measure/report/report_json.h"
#include "measure/stability/cases.h"
#include "scene/motion.h"
#include "scene/scene_file.h"
#include "teach/lesson_read.h"
#include "teach/marking/exercise_read.h"
#include "words/words.h"

namespace sandbox {

std::vector<JsonReader> json_readers() {
    static const Assets assets("assets");
    static const Words words("en", "{}", "en.json");
    const std::string name = "a.json";
    return {{"scene", [=](const std::string &text) { parse_scene(text, name, {}); }},
            {"sidecar", [=](const std::string &text) { sidecar_options(text, name); }},
            {"turntable", [=](const std::string &text) { turntable_of(text, name); }},
            {"motion of a sidecar", [=](const std::string &text) { motion_of(text, name); }},
            {"motion", [=](const std::string &text) { parse_motion(text, name); }},
            {"grid", [=](const std::string &text) { grid_of(text, name); }},
            {"report", [=](const std::string &text) { read_report_json(text, name); }},
            {"case", [=](const std::string &text) { parse_stability_case(text, name, {}, assets); }},
            {"lesson", [=](const std::string &text) { parse_lesson(text, name, {}, assets, words); }},
            {"exercise", [=](const std::string &text) { parse_exercise(text, name, {}, assets, words); }},
            {"words", [=](const std::string &text) { Words("en", text, name); }}};
}

} // namespace sandbox
