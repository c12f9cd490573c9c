#include "scene/obj_reader.h"

#include "image/error.h"
#include "scene/obj_faces.h"
#include "scene/obj_mesh.h"
#include "scene/obj_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace sandbox {
namespace {

/// Elements that are drawn by no triangle.
struct Undrawn {
    std::string_view keyword, one, many;
};
constexpr std::array<Undrawn, 5> undrawn{{{"l", "line", "lines"},
                                          {"p", "point", "points"},
                                          {"curv", "curve", "curves"},
                                          {"curv2", "curve on a surface", "curves on surfaces"},
                                          {"surf", "free-form surface", "free-form surfaces"}}};

class ObjReader {
  public:
    ObjReader(std::string_view text, std::string_view name) : text_(text, name), name_(name) {}

    Mesh read(std::vector<std::string> &notes) {
        while (text_.next_line()) {
            read_line();
        }
        if (file_.faces.empty() && !undrawn_text().empty()) {
            throw InputError("{}: expected faces (f), got {} only", name_, undrawn_text());
        }
        check_indices();
        Mesh mesh = mesh_of_faces_here();
        if (mesh.triangles.empty()) {
            throw InputError("{}: expected at least one triangle with an area, got none", name_);
        }
        add_notes(notes);
        return mesh;
    }

  private:
    ObjText text_;
    std::string name_;
    ObjFaces file_;
    SmoothingGroup group_ = ungrouped;
    std::map<std::string, SmoothingGroup, std::less<>> groups_;
    std::array<std::size_t, undrawn.size()> undrawn_counts_{};
    std::size_t libraries_ = 0;

    void read_line() {
        const std::string_view keyword = text_.next_word();
        if (keyword == "v") {
            file_.positions.push_back(read_position());
        } else if (keyword == "vt") {
            file_.uvs.push_back(read_uv());
        } else if (keyword == "vn") {
            file_.normals.push_back(read_normal());
        } else if (keyword == "f") {
            read_face();
        } else if (keyword == "s") {
            group_ = read_group();
        } else if (keyword == "mtllib") {
            ++libraries_;
        } else if (const auto kind = std::ranges::find(undrawn, keyword, &Undrawn::keyword); kind != undrawn.end()) {
            ++undrawn_counts_[static_cast<std::size_t>(kind - undrawn.begin())];
        }
    }

    /// What follows the third (w, a colour) is ignored.
    glm::dvec3 read_position() {
        glm::dvec3 out(0);
        for (int i = 0; i < 3; ++i) {
            out[i] = text_.number(needed_word(3, i), 1e9);
        }
        return out;
    }

    glm::dvec2 read_uv() {
        glm::dvec2 out(text_.number(needed_word(1, 0), 1e9), 0);
        if (const std::string_view word = text_.next_word(); !word.empty()) {
            out.y = text_.number(word, 1e9);
        }
        return out;
    }

    /// All NaN where a part is not finite, in whatever words a C library prints that: nan, -nan(ind), 1.#QNAN, inf.
    glm::dvec3 read_normal() {
        glm::dvec3 out(0);
        bool finite = true;
        for (int i = 0; i < 3; ++i) {
            const std::string_view word = needed_word(3, i);
            const std::size_t sign = word.starts_with('-') || word.starts_with('+') ? 1 : 0;
            const std::string_view letters = word.substr(sign, 3);
            const bool named = std::ranges::any_of(std::array{"nan", "NaN", "NAN", "inf", "Inf", "INF", "1.#"},
                                                   [&](const char *start) { return letters == start; });
            finite = finite && !named;
            out[i] = named ? 0 : text_.number(word, 1e300);
        }
        return finite ? out : glm::dvec3(std::numeric_limits<double>::quiet_NaN());
    }

    std::string_view needed_word(int needed, int got) {
        const std::string_view word = text_.next_word();
        if (word.empty()) {
            text_.refuse("expected {} number{}, got {}", needed, needed == 1 ? "" : "s", got);
        }
        return word;
    }

    SmoothingGroup read_group() {
        const std::string_view word = text_.next_word();
        if (word.empty() || word == "off" || word.find_first_not_of('0') == std::string_view::npos) {
            return unsmoothed;
        }
        const auto found = groups_.find(word);
        return found != groups_.end()
                   ? found->second
                   : groups_.emplace(word, static_cast<SmoothingGroup>(groups_.size()) + ungrouped + 1).first->second;
    }

    /// A 1-based index, which may name what is still to come, or a negative one, which counts backward from here.
    /// `bad_allowed`: one that names nothing is ObjCorner::bad_index.
    std::uint32_t index(std::string_view word, std::size_t count, const char *kind, bool bad_allowed = false) const {
        long long value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (word.empty() || error != std::errc() || end != word.data() + word.size()) {
            text_.refuse("expected an index, got \"{:.40}\"", word);
        }
        const long long at = value > 0 ? value - 1 : static_cast<long long>(count) + value;
        if (bad_allowed && (value == 0 || (value < 0 && count == 0))) {
            return ObjCorner::bad_index;
        }
        if (value == 0 || at < 0 || at > ObjCorner::most) {
            text_.refuse("index {} is out of range; there are {} {} so far", value, count, kind);
        }
        return static_cast<std::uint32_t>(at);
    }

    /// v, v/vt, v//vn or v/vt/vn; nothing behind a slash is no index.
    ObjCorner read_corner(std::string_view word) const {
        std::array<std::string_view, 3> parts;
        std::size_t count = 0;
        for (std::string_view rest = word;; ++count) {
            if (count == 3) {
                text_.refuse("expected v/vt/vn, got \"{:.40}\"", word);
            }
            const std::size_t slash = rest.find('/');
            parts[count] = rest.substr(0, slash);
            if (slash == std::string_view::npos) {
                break;
            }
            rest.remove_prefix(slash + 1);
        }
        ObjCorner corner;
        corner.v = index(parts[0], file_.positions.size(), "v");
        if (!parts[1].empty()) {
            corner.vt = index(parts[1], file_.uvs.size(), "vt");
        }
        if (!parts[2].empty()) {
            corner.vn = index(parts[2], file_.normals.size(), "vn", true);
        }
        return corner;
    }

    void read_face() {
        ObjFace face{file_.corners.size(), 0, group_, text_.line_number()};
        for (std::string_view word = text_.next_word(); !word.empty(); word = text_.next_word()) {
            file_.corners.push_back(read_corner(word));
            ++face.corner_count;
        }
        if (face.corner_count < 3) {
            text_.refuse("expected a face of at least 3 corners, got {}", face.corner_count);
        }
        file_.faces.push_back(face);
    }

    void check_indices() const {
        for (const ObjFace &face : file_.faces) {
            const auto check = [&](std::uint32_t index, std::size_t count, const char *kind) {
                if (index >= count && index <= ObjCorner::most) {
                    text_.refuse_line(face.line, fmt::format("index {} is out of range; there are {} {}",
                                                             std::uint64_t{index} + 1, count, kind));
                }
            };
            for (const ObjCorner &corner : file_.corners_of(face)) {
                check(corner.v, file_.positions.size(), "v");
                check(corner.vt, file_.uvs.size(), "vt");
                if (!file_.normals.empty()) {
                    check(corner.vn, file_.normals.size(), "vn");
                }
            }
        }
    }

    [[nodiscard]] Mesh mesh_of_faces_here() const {
        try {
            return mesh_of_faces(file_);
        } catch (const InputError &error) {
            throw InputError("{}:{}", name_, error.what());
        }
    }

    /// "2 lines, 1 point"; empty: none.
    [[nodiscard]] std::string undrawn_text() const {
        std::string out;
        for (std::size_t i = 0; i < undrawn.size(); ++i) {
            if (const std::size_t count = undrawn_counts_[i]; count > 0) {
                out += fmt::format("{}{} {}", out.empty() ? "" : ", ", count,
                                   count == 1 ? undrawn[i].one : undrawn[i].many);
            }
        }
        return out;
    }

    void add_notes(std::vector<std::string> &notes) const {
        if (const std::string elements = undrawn_text(); !elements.empty()) {
            notes.push_back(fmt::format("only faces are drawn; left out: {}", elements));
        }
        if (libraries_ > 0) {
            notes.emplace_back("mtllib is ignored; materials come from the scene");
        }
        const auto useless = std::ranges::count_if(file_.corners, [&](const ObjCorner &corner) {
            return corner.vn != ObjCorner::no_index && !file_.has_normal(corner);
        });
        if (useless > 0) {
            notes.push_back(fmt::format("{} corner{} a normal that is of no use ({}); it is computed instead", useless,
                                        useless == 1 ? " names" : "s name",
                                        file_.normals.empty() ? "the file has no vn" : "0, not finite, or index 0"));
        }
    }
};

} // namespace

Mesh read_obj(std::string_view text, std::string_view name, std::vector<std::string> &notes) {
    Mesh mesh = ObjReader(text, name).read(notes);
    summarise(mesh);
    if (std::string note = winding_note(mesh); !note.empty()) {
        notes.push_back(std::move(note));
    }
    return mesh;
}

Mesh read_obj(std::string_view text, std::string_view name) {
    std::vector<std::string> unsaid;
    return read_obj(text, name, unsaid);
}

} // namespace sandbox
