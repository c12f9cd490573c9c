#include "scene/mtl_reader.h"

#include "scene/scene_format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sandbox {
namespace {

/// A key of three numbers (or of one for all three).
struct ColorKey {
    std::string_view key;
    glm::dvec3 Material::*member;
};
constexpr std::array<ColorKey, 4> color_keys{
    {{"Ka", &Material::ambient}, {"Kd", &Material::diffuse}, {"Ks", &Material::specular}, {"Ke", &Material::emission}}};

/// An option before a map's file name, and how many words follow it: at least, and at most if they are numbers.
struct MapOption {
    std::string_view word;
    int least, most;
};
constexpr std::array<MapOption, 12> map_options{{{"-blendu", 1, 1},
                                                 {"-blendv", 1, 1},
                                                 {"-boost", 1, 1},
                                                 {"-bm", 1, 1},
                                                 {"-cc", 1, 1},
                                                 {"-clamp", 1, 1},
                                                 {"-imfchan", 1, 1},
                                                 {"-mm", 2, 2},
                                                 {"-o", 1, 3},
                                                 {"-s", 1, 3},
                                                 {"-t", 1, 3},
                                                 {"-texres", 1, 1}}};

std::string_view first_word(std::string_view text) { return text.substr(0, text.find_first_of(" \t\v\f")); }
std::string_view without_first_word(std::string_view text) {
    text.remove_prefix(first_word(text).size());
    text.remove_prefix(std::min(text.find_first_not_of(" \t\v\f"), text.size()));
    return text;
}

class MtlReader {
  public:
    MtlReader(TextSource source, std::string_view name, const Material &base)
        : text_(std::move(source), name), base_(base) {}

    std::map<std::string, Material, std::less<>> read(std::vector<std::string> &notes) {
        while (text_.next_line()) {
            read_line();
        }
        if (!left_out_.empty()) {
            notes.push_back(
                fmt::format("only Ka, Kd, Ks, Ke, Ns and map_Kd are taken; left out: {}", fmt::join(left_out_, ", ")));
        }
        return std::move(materials_);
    }

  private:
    ObjText text_;
    const Material &base_;
    std::map<std::string, Material, std::less<>> materials_;
    Material *material_ = nullptr;
    Material unwanted_;                 ///< takes what is said of a name a second time: the first stands
    std::vector<std::string> left_out_; ///< keys, each once

    void read_line() {
        const std::string keyword(text_.next_word());
        if (keyword.empty()) {
            return;
        }
        if (keyword == "newmtl") {
            begin_material();
        } else if (const auto color = std::ranges::find(color_keys, keyword, &ColorKey::key);
                   color != color_keys.end()) {
            read_color(keyword, material().*color->member);
        } else if (keyword == "Ns") {
            material().shininess = number(keyword, needed_word(keyword), shininess);
        } else if (keyword == "map_Kd") {
            read_map();
        } else {
            leave_out(keyword);
        }
    }

    void begin_material() {
        const std::string name = text_.rest();
        if (name.empty()) {
            text_.refuse("newmtl: expected a name");
        }
        const auto [found, added] = materials_.try_emplace(name, base_);
        unwanted_ = base_;
        material_ = added ? &found->second : &unwanted_;
    }

    Material &material() {
        if (material_ == nullptr) {
            text_.refuse("expected newmtl before what a material is made of");
        }
        return *material_;
    }

    void leave_out(std::string_view key) {
        constexpr std::size_t most = 20; // a sentence that can be read
        const auto readable = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-' || c == ' '; };
        if (left_out_.size() < most && key.size() <= most && std::ranges::all_of(key, readable) &&
            std::ranges::find(left_out_, key) == left_out_.end()) {
            left_out_.emplace_back(key);
        }
    }

    std::string_view needed_word(std::string_view key) {
        const std::string_view word = text_.next_word();
        if (word.empty()) {
            text_.refuse("{}: expected a number, got the end of the line", key);
        }
        return word;
    }

    [[nodiscard]] double number(std::string_view key, std::string_view word, const Range &range) const {
        const auto value = ObjText::finite_number(word);
        if (!value || *value < range.low || *value > range.high) {
            text_.refuse("{}: expected a number from {:g} to {:g}, got \"{:.40}\"", key, range.low, range.high, word);
        }
        return *value;
    }

    void read_color(std::string_view key, glm::dvec3 &out) {
        std::string_view word = needed_word(key);
        if (word == "spectral" || word == "xyz") {
            leave_out(fmt::format("{} {}", key, word));
            return;
        }
        out = glm::dvec3(number(key, word, linear_rgb));
        word = text_.next_word();
        if (!word.empty()) {
            out.y = number(key, word, linear_rgb);
            out.z = number(key, needed_word(key), linear_rgb);
        }
    }

    void read_map() {
        const std::string line = text_.rest();
        std::string_view rest = line;
        for (auto option = map_options.begin(); option != map_options.end();) {
            option = std::ranges::find(map_options, first_word(rest), &MapOption::word);
            if (option == map_options.end()) {
                break;
            }
            leave_out(fmt::format("map_Kd {}", option->word));
            rest = without_first_word(rest);
            for (int i = 0; i < option->most; ++i) {
                if (i < option->least || ObjText::finite_number(first_word(rest))) {
                    rest = without_first_word(rest);
                }
            }
        }
        if (rest.empty()) {
            text_.refuse("map_Kd: expected a file name");
        }
        material().texture = rest;
        material().texture_modulates_specular = false;
    }
};

} // namespace

std::map<std::string, Material, std::less<>> read_mtl(TextSource source, std::string_view name, const Material &base,
                                                      std::vector<std::string> &notes) {
    return MtlReader(std::move(source), name, base).read(notes);
}

} // namespace sandbox
