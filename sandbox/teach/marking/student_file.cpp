#include "teach/marking/student_file.h"

#include "image/plain_text.h"
#include "shading/own_files.h"

#include <fmt/format.h>
#include <string_view>

namespace sandbox {
namespace {

/// Comment lines of at most a hundred characters.
std::string comment(std::string_view text) {
    constexpr std::size_t longest = 100;
    std::string out;
    while (!text.empty()) {
        const std::size_t space = text.size() > longest ? text.rfind(' ', longest) : std::string_view::npos;
        out += fmt::format("// {}\n", text.substr(0, space));
        text.remove_prefix(space == std::string_view::npos ? text.size() : space + 1);
    }
    return out;
}

} // namespace

std::string student_file(const Exercise &exercise, const ShaderParts &parts) {
    return comment(plain_text(exercise.title.text)) + comment(plain_text(exercise.task.text)) +
           fmt::format("//   shading-sandbox mark {}.json {}.glsl\n//\n", exercise.name, exercise.name) +
           own_starter({}, exercise.target, parts);
}

} // namespace sandbox
