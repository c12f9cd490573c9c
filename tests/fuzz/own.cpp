#include "shading/own_text.h"

#include "fuzz/target.h"
#include "fuzz/targets.h"
#include "shading/own_files.h"
#include "shading/own_shader.h"
#include "shading/parts.h"

#include <algorithm>

namespace sandbox {

/// What an answer's or a stranger's text becomes is compiled by a driver: every byte of it is one that GLSL has.
void check_own(std::string_view bytes) {
    const auto own = accepted([&] { return read_own_text("a.glsl", std::string(bytes)); });
    if (!own) {
        return;
    }
    held(own->text == bytes, "the text is kept");
    std::string compiled;
    for (const std::string &line : own->lines) {
        held(std::ranges::all_of(line, [](char c) { return c >= 32 && c < 127; }), "a line is plain: " + line);
        held(line.find("//") == std::string::npos && line.find("/*") == std::string::npos, "no comment: " + line);
        held(line.find('#') == std::string::npos && line.find('\\') == std::string::npos, "no directive: " + line);
        compiled += line + "\n";
    }
    held(compiled.find("lighting") != std::string::npos, "it lights");
    held(OwnShader("a.glsl", std::string(bytes)) == OwnShader("a.glsl", std::string(bytes)), "equal texts are equal");
}

std::vector<std::string> own_seeds() {
    const ShaderParts parts{Assets("shaders")};
    const OwnReader nobody;
    std::vector<std::string> seeds = kept_inputs("seeds", "own");
    for (const char *name : {"per-pixel/phong", "per-pixel/lambert", "per-vertex/blinn-phong"}) {
        seeds.push_back(own_answer(nobody, parse_technique(name), parts));
    }
    seeds.push_back(own_starter(nobody, parse_technique("per-pixel/phong"), parts));
    return seeds;
}

} // namespace sandbox
