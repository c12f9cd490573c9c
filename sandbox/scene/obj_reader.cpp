#include "scene/obj_reader.h"

#include "image/error.h"
#include "image/file_io.h"
#include "image/plain_text.h"
#include "scene/budget.h"
#include "scene/obj_faces.h"
#include "scene/obj_mesh.h"
#include "scene/obj_text.h"
#include "scene/scene_format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <type_traits>
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
    ObjReader(TextSource source, std::string_view name) : text_(std::move(source), name), name_(name) {}

    Mesh read_whole(std::vector<std::string> &notes) {
        read_lines();
        Mesh mesh = here([&] { return mesh_of_faces(file_); });
        require_triangles(mesh.triangles.size());
        add_notes(notes, !libraries_.empty());
        summarise(mesh);
        add_winding_note(mesh.against_normals, mesh.triangles.size(), notes);
        return mesh;
    }

    ObjModel read_parts(std::vector<std::string> &notes) {
        read_lines();
        std::vector<Mesh> meshes = here([&] { return meshes_of_faces(file_); });
        ObjModel model;
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            if (!meshes[i].triangles.empty()) {
                model.parts.push_back({file_.materials[i], std::move(meshes[i])});
            }
        }
        require_triangles(model.parts.size());
        model.libraries = libraries_;
        add_notes(notes, false);
        std::size_t against = 0;
        std::size_t triangles = 0;
        for (ObjModel::Part &part : model.parts) {
            summarise(part.mesh);
            against += part.mesh.against_normals;
            triangles += part.mesh.triangles.size();
        }
        add_winding_note(against, triangles, notes);
        return model;
    }

  private:
    ObjText text_;
    std::string name_;
    ObjFaces file_;
    SmoothingGroup group_ = ungrouped;
    std::map<std::string, SmoothingGroup, std::less<>> groups_;
    std::array<std::size_t, undrawn.size()> undrawn_counts_{};
    std::map<std::string, std::uint32_t, std::less<>> materials_;
    std::uint32_t material_ = 0;
    std::vector<std::string> libraries_;
    std::size_t triangles_ = 0;
    std::size_t bad_colors_ = 0;

    void read_lines() {
        while (text_.next_line()) {
            read_line();
        }
        if (file_.faces.empty() && !undrawn_text().empty()) {
            throw InputError("{}: expected faces (f), got {} only", name_, undrawn_text());
        }
        if (!file_.colors.empty()) {
            file_.colors.resize(file_.positions.size(), glm::dvec3(1));
        }
        check_indices();
    }

    void require_triangles(std::size_t count) const {
        if (count == 0) {
            throw InputError("{}: expected at least one triangle with an area, got none", name_);
        }
    }

    static void add_winding_note(std::size_t against, std::size_t triangles, std::vector<std::string> &notes) {
        if (std::string note = winding_note(against, triangles); !note.empty()) {
            notes.push_back(std::move(note));
        }
    }

    void read_line() {
        const std::string_view keyword = text_.next_word();
        if (keyword == "v") {
            file_.positions.push_back(read_position());
            read_color();
        } else if (keyword == "vt") {
            file_.uvs.push_back(read_uv());
        } else if (keyword == "vn") {
            file_.normals.push_back(read_normal());
        } else if (keyword == "f") {
            read_face();
        } else if (keyword == "s") {
            group_ = read_group();
        } else if (keyword == "mtllib") {
            libraries_.push_back(text_.rest());
        } else if (keyword == "usemtl") {
            read_material();
        } else if (const auto kind = std::ranges::find(undrawn, keyword, &Undrawn::keyword); kind != undrawn.end()) {
            ++undrawn_counts_[static_cast<std::size_t>(kind - undrawn.begin())];
        }
    }

    glm::dvec3 read_position() {
        glm::dvec3 out(0);
        for (int i = 0; i < 3; ++i) {
            out[i] = text_.number(needed_word(3, i), 1e9);
        }
        return out;
    }

    /// Behind the position: three numbers or more. One alone is w, which is ignored.
    void read_color() {
        std::string_view word = text_.next_word();
        if (word.empty()) {
            return;
        }
        glm::dvec3 color(1);
        int count = 0;
        bool good = true;
        for (; count < 3 && !word.empty(); ++count, word = text_.next_word()) {
            color[count] = ObjText::finite_number(word).value_or(-1);
            good = good && color[count] >= 0 && color[count] <= linear_rgb.high;
        }
        if (count < 3) {
            return;
        }
        bad_colors_ += good ? 0 : 1;
        file_.colors.resize(file_.positions.size() - 1, glm::dvec3(1));
        file_.colors.push_back(good ? color : glm::dvec3(1));
    }

    void read_material() {
        const std::string name = text_.rest();
        if (name.empty()) {
            material_ = 0;
            return;
        }
        const auto next = static_cast<std::uint32_t>(file_.materials.size());
        const auto [found, added] = materials_.try_emplace(name, next);
        if (added) {
            file_.materials.push_back(name);
        }
        material_ = found->second;
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

    /// Of at most 9 digits and nothing else, as nearly all are; else 0.
    static std::uint32_t short_index(std::string_view word) {
        std::uint32_t value = 0;
        for (const char c : word.substr(0, 10)) {
            const auto digit = static_cast<unsigned>(c - '0');
            if (digit > 9) {
                return 0;
            }
            value = value * 10 + digit;
        }
        return word.size() <= 9 ? value : 0;
    }

    /// A 1-based index, which may name what is still to come, or a negative one, which counts backward from here.
    /// `bad_allowed`: one that names nothing is ObjCorner::bad_index.
    std::uint32_t index(std::string_view word, std::size_t count, const char *kind, bool bad_allowed = false) const {
        if (const std::uint32_t value = short_index(word); value > 0) {
            return value - 1;
        }
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
        ObjFace face{static_cast<std::uint32_t>(file_.corners.size()), 0, group_,
                     static_cast<std::uint32_t>(text_.line_number()), material_};
        for (std::string_view word = text_.next_word(); !word.empty(); word = text_.next_word()) {
            file_.corners.push_back(read_corner(word));
            ++face.corner_count;
        }
        if (face.corner_count < 3) {
            text_.refuse("expected a face of at least 3 corners, got {}", face.corner_count);
        }
        triangles_ += face.corner_count - 2;
        if (triangles_ > most_triangles) {
            text_.refuse("more than {} triangles so far; a scene's meshes may have no more", most_triangles);
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

    /// An error gets the file's name.
    template <class Make> [[nodiscard]] std::invoke_result_t<Make> here(const Make &make) const {
        try {
            return make();
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

    void add_notes(std::vector<std::string> &notes, bool ignores_libraries) const {
        if (const std::string elements = undrawn_text(); !elements.empty()) {
            notes.push_back(fmt::format("only faces are drawn; left out: {}", elements));
        }
        if (ignores_libraries) {
            notes.emplace_back("mtllib is ignored; materials come from the scene");
        }
        if (bad_colors_ > 0) {
            notes.push_back(fmt::format("{} colour{} not finite, below 0 or above 1e6; {} as white", bad_colors_,
                                        bad_colors_ == 1 ? " of a vertex is" : "s of vertices are",
                                        bad_colors_ == 1 ? "it counts" : "they count"));
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

/// Hands a reader the blocks of the file.
template <class Read> auto from_file(const std::filesystem::path &path, const Read &read) {
    FileReader file(path);
    return read([&](std::span<char> bytes) { return file.read(bytes); }, path.string());
}

} // namespace

Mesh read_obj(std::string_view text, std::string_view name, std::vector<std::string> &notes) {
    return ObjReader(source_of(text), name).read_whole(notes);
}

Mesh read_obj_file(const std::filesystem::path &path, std::vector<std::string> &notes) {
    return from_file(path, [&](const TextSource &source, const std::string &name) {
        return ObjReader(source, name).read_whole(notes);
    });
}

ObjModel read_obj_model(TextSource source, std::string_view name, std::vector<std::string> &notes) {
    return ObjReader(std::move(source), name).read_parts(notes);
}

ObjModel read_obj_model_file(const std::filesystem::path &path, std::vector<std::string> &notes) {
    return from_file(
        path, [&](const TextSource &source, const std::string &name) { return read_obj_model(source, name, notes); });
}

void say_notes(std::string_view name, const std::vector<std::string> &notes) {
    constexpr std::size_t most = 12; // of a model with hundreds of materials
    for (const std::string &note : std::span(notes).first(std::min(notes.size(), most))) {
        fmt::print(stderr, "note: {}: {}\n", plain_text(name), plain_text(note));
    }
    if (notes.size() > most) {
        fmt::print(stderr, "note: {}: and {} more notes of this kind\n", plain_text(name), notes.size() - most);
    }
}

Mesh read_obj(std::string_view text, std::string_view name) {
    std::vector<std::string> unsaid;
    return read_obj(text, name, unsaid);
}

} // namespace sandbox
