#include "commands/help.h"

#include "shading/technique.h"

namespace sandbox {
namespace {

std::string value_lines(const TechniqueKey &key, const std::string &indent) {
    std::string lines;
    for (const TechniqueValue &value : key.values) {
        const std::string name(value.name);
        lines += indent + name + std::string(name.size() < 22 ? 22 - name.size() : 1, ' ') +
                 std::string(value.look_for) + "\n";
    }
    return lines;
}

std::string technique_help() {
    std::string text = "Technique T: FREQUENCY/MODEL[:key=value[,key=value]], e.g. per-vertex/phong or\n"
                       "per-pixel/blinn-phong:power=textbook. The first value of a key is its default; a key that can\n"
                       "have no effect under the frequency or model is refused.\n";
    for (const TechniqueKey &key : technique_keys()) {
        text += "  " + std::string(key.name) + ": " + std::string(key.doc) + "\n" + value_lines(key, "    ");
    }
    return text;
}

} // namespace

std::string help_footer() {
    return technique_help() +
           "\nSCENE is the name of a built-in scene (see: shading-sandbox list), or a path to a scene (.json), to a\n"
           "picture's sidecar (.png.json), or to a mesh (.obj).\n"
           "Each command has its own --help.\n"
           "Exit code: 0 done; 1 a check said no; 2 bad usage or bad input; 3 the machine lacks something; 130 "
           "interrupted.";
}

} // namespace sandbox
