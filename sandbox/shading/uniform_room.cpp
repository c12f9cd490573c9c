#include "shading/uniform_room.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <map>
#include <sstream>

namespace sandbox {
namespace {

/// How many vectors have so many components in use.
struct Room {
    int full = 0, three = 0, two = 0, one = 0;

    void add(const Room &other, int times) {
        full += times * other.full;
        three += times * other.three;
        two += times * other.two;
        one += times * other.one;
    }
    [[nodiscard]] int vectors() const { return full + three + (two + 1) / 2 + (std::max(one - three, 0) + 3) / 4; }
};

using Types = std::map<std::string, Room, std::less<>>;

const Types &basic_types() {
    static const Types types{{"vec4", {1, 0, 0, 0}}, {"ivec4", {1, 0, 0, 0}}, {"mat4", {4, 0, 0, 0}},
                             {"vec3", {0, 1, 0, 0}}, {"ivec3", {0, 1, 0, 0}}, {"mat3", {0, 3, 0, 0}},
                             {"vec2", {0, 0, 1, 0}}, {"ivec2", {0, 0, 1, 0}}, {"float", {0, 0, 0, 1}},
                             {"int", {0, 0, 0, 1}},  {"uint", {0, 0, 0, 1}},  {"bool", {0, 0, 0, 1}}};
    return types;
}

/// "vec3 a, b[2]": what its names take together. A type that is not known, as a sampler's, takes none.
Room room_of(std::string_view declaration, const Types &types) {
    const std::size_t begin = std::min(declaration.find_first_not_of(' '), declaration.size());
    declaration.remove_prefix(begin);
    const auto type = types.find(declaration.substr(0, declaration.find(' ')));
    Room room;
    while (type != types.end() && !declaration.empty()) {
        const std::string_view name = declaration.substr(0, declaration.find(','));
        declaration.remove_prefix(std::min(name.size() + 1, declaration.size()));
        int length = 1;
        if (const std::size_t bracket = name.find('['); bracket != std::string_view::npos) {
            std::from_chars(name.data() + bracket + 1, name.data() + name.size(), length);
        }
        room.add(type->second, length);
    }
    return room;
}

} // namespace

int uniform_vectors(std::string_view glsl) {
    constexpr std::string_view uniform = "uniform ", structure = "struct ";
    Types types = basic_types();
    std::istringstream lines{std::string(glsl)};
    Room all;
    Room *members = nullptr; // of the struct that is being read
    for (std::string line; std::getline(lines, line);) {
        const std::string_view text = std::string_view(line).substr(0, line.find("//"));
        const std::string_view declaration = text.substr(0, text.find(';'));
        if (text.starts_with(structure)) {
            const std::string_view name = text.substr(structure.size());
            members = &types[std::string(name.substr(0, name.find_first_of(" {")))];
        } else if (text.starts_with('}')) {
            members = nullptr;
        } else if (members != nullptr) {
            members->add(room_of(declaration, types), 1);
        } else if (text.starts_with(uniform)) {
            all.add(room_of(declaration.substr(uniform.size()), types), 1);
        }
    }
    return all.vectors();
}

std::string uniform_refusal(std::string_view stage, int needed, int available) {
    return needed <= available
               ? ""
               : fmt::format(
                     "the {} stage needs room for {} uniform vectors, and this device has {}: try fewer lights, "
                     "or program=specialised",
                     stage, needed, available);
}

} // namespace sandbox
