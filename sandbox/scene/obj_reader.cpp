#include "scene/obj_reader.h"

#include "image/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <map>
#include <optional>

namespace sandbox {
namespace {

constexpr std::uint32_t none = 0xffffffffU;

/// Indices into the file's v, vt and vn lists; `none` where a corner names none.
using Corner = std::array<std::uint32_t, 3>;

double largest_part(const glm::dvec3 &v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Scaled first: the square of 1e-200 is 0. Zero stays zero.
glm::dvec3 unit(const glm::dvec3 &v) {
    const double largest = largest_part(v);
    return largest > 0 ? glm::normalize(v / largest) : glm::dvec3(0);
}

class ObjReader {
  public:
    ObjReader(std::string_view text, std::string_view name) : text_(text), name_(name) {}

    Mesh read() {
        while (next_line()) {
            const std::string_view keyword = next_word();
            if (keyword == "v") {
                positions_.push_back(read_vector(3, 1e9));
            } else if (keyword == "vt") {
                const glm::dvec3 uv = read_vector(1, 1e9);
                uvs_.emplace_back(uv.x, uv.y);
            } else if (keyword == "vn") {
                file_normals_.push_back(read_vector(3, 1e300));
                normals_.push_back(unit(file_normals_.back()));
            } else if (keyword == "f") {
                read_face();
            } else if (keyword == "mtllib") {
                fmt::print(stderr, "note: {}:{}: mtllib is ignored; materials come from the scene\n", name_,
                           line_number_);
            }
        }
        if (mesh_.triangles.empty()) {
            throw InputError("{}: expected at least one triangle with an area, got none", name_);
        }
        finish();
        return std::move(mesh_);
    }

  private:
    std::string_view text_, line_;
    std::string name_;
    std::size_t line_number_ = 0;
    std::vector<glm::dvec3> positions_, normals_, file_normals_;
    std::vector<std::array<std::uint32_t, 3>> flat_; ///< triangles without area, which are dropped, by position
    std::vector<glm::dvec2> uvs_;
    std::map<Corner, std::uint32_t> vertices_;
    std::vector<Corner> corners_; ///< of each vertex of the mesh
    Mesh mesh_;

    template <typename... Values>
    [[noreturn]] void refuse(fmt::format_string<Values...> what, Values &&...values) const {
        throw InputError("{}:{}: {}", name_, line_number_, fmt::format(what, std::forward<Values>(values)...));
    }

    /// The next line, without its comment.
    bool next_line() {
        if (text_.empty()) {
            return false;
        }
        const std::size_t end = text_.find('\n');
        line_ = text_.substr(0, end);
        text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
        ++line_number_;
        line_ = line_.substr(0, line_.find('#'));
        const std::size_t last = line_.find_last_not_of(" \t\r");
        if (last != std::string_view::npos && line_[last] == '\\') {
            refuse("a line continued with \\ is not supported");
        }
        return true;
    }

    std::string_view next_word() {
        line_.remove_prefix(std::min(line_.find_first_not_of(" \t\r"), line_.size()));
        const std::string_view word = line_.substr(0, line_.find_first_of(" \t\r"));
        line_.remove_prefix(word.size());
        return word;
    }

    double number(std::string_view word, double limit) const {
        double value = 0;
        const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        const bool whole = !digits.empty() && !word.starts_with("+-") && end == digits.data() + digits.size();
        // A number too small for a double is 0; one too large is refused with NaN and infinity.
        const std::size_t exponent = std::min(digits.find_first_of("eE"), digits.size());
        const bool tiny =
            error == std::errc::result_out_of_range && digits.substr(exponent).find('-') != std::string_view::npos;
        if (whole && tiny) {
            return 0;
        }
        if (!whole || error != std::errc() || !(std::abs(value) <= limit)) {
            refuse("expected a number, got \"{:.40}\"", word);
        }
        return value;
    }

    /// `least` to 3 numbers; what follows (w, colours) must be numbers too and is ignored.
    glm::dvec3 read_vector(int least, double limit) {
        glm::dvec3 out(0);
        int count = 0;
        for (std::string_view word = next_word(); !word.empty(); word = next_word(), ++count) {
            const double value = number(word, limit);
            if (count < 3) {
                out[count] = value;
            }
        }
        if (count < least) {
            refuse("expected {} numbers, got {}", least, count);
        }
        return out;
    }

    /// A 1-based or, if negative, backward-counting index.
    std::uint32_t index(std::string_view word, std::size_t count, const char *kind) const {
        long long value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (word.empty() || error != std::errc() || end != word.data() + word.size()) {
            refuse("expected an index, got \"{:.40}\"", word);
        }
        const auto size = static_cast<long long>(count);
        const long long at = value > 0 ? value - 1 : size + value;
        if (value == 0 || at < 0 || at >= size) {
            refuse("index {} is out of range; there are {} {} so far", value, count, kind);
        }
        return static_cast<std::uint32_t>(at);
    }

    /// v, v/vt, v//vn or v/vt/vn.
    Corner read_corner(std::string_view word) const {
        std::array<std::string_view, 3> parts;
        std::size_t count = 0;
        for (std::string_view rest = word;; ++count) {
            if (count == 3) {
                refuse("expected v/vt/vn, got \"{:.40}\"", word);
            }
            const std::size_t slash = rest.find('/');
            parts[count] = rest.substr(0, slash);
            if (slash == std::string_view::npos) {
                break;
            }
            rest.remove_prefix(slash + 1);
        }
        Corner corner{index(parts[0], positions_.size(), "v"), none, none};
        if (!parts[1].empty() || count == 1) {
            corner[1] = index(parts[1], uvs_.size(), "vt");
        }
        if (count == 2) {
            corner[2] = index(parts[2], normals_.size(), "vn");
        }
        return corner;
    }

    void read_face() {
        std::vector<Corner> face;
        for (std::string_view word = next_word(); !word.empty(); word = next_word()) {
            face.push_back(read_corner(word));
        }
        if (face.size() < 3) {
            refuse("expected a face of at least 3 corners, got {}", face.size());
        }
        for (std::size_t i = 2; i < face.size(); ++i) {
            add_triangle(face[0], face[i - 1], face[i]);
        }
    }

    /// Twice the area times the normal.
    [[nodiscard]] glm::dvec3 area_vector(const Corner &a, const Corner &b, const Corner &c) const {
        const glm::dvec3 ab = positions_[b[0]] - positions_[a[0]];
        const glm::dvec3 ac = positions_[c[0]] - positions_[a[0]];
        return glm::cross(ab, ac);
    }

    void add_triangle(const Corner &a, const Corner &b, const Corner &c) {
        if (area_vector(a, b, c) == glm::dvec3(0)) {
            flat_.push_back({a[0], b[0], c[0]});
            return;
        }
        const glm::uvec3 triangle{vertex(a), vertex(b), vertex(c)}; // braces: from left to right
        mesh_.triangles.push_back(triangle);
    }

    std::uint32_t vertex(const Corner &corner) {
        const auto [found, added] = vertices_.try_emplace(corner, static_cast<std::uint32_t>(corners_.size()));
        if (added) {
            corners_.push_back(corner);
        }
        return found->second;
    }

    void finish() {
        const std::vector<glm::dvec3> smooth = smooth_normals();
        const bool has_uvs = std::ranges::any_of(corners_, [](const Corner &c) { return c[1] != none; });
        for (const Corner &corner : corners_) {
            mesh_.positions.push_back(positions_[corner[0]]);
            glm::dvec3 normal = corner[2] != none ? normals_[corner[2]] : glm::dvec3(0);
            if (normal == glm::dvec3(0)) { // none given, or (0, 0, 0)
                normal = smooth[corner[0]];
            }
            mesh_.normals.push_back(normal);
            if (has_uvs) {
                mesh_.uvs.push_back(corner[1] != none ? uvs_[corner[1]] : glm::dvec2(0));
            }
        }
        keep_file_normals();
    }

    /// Where a reader without guards has other normals: too short or too long to be made unit in float32, or not
    /// finite.
    void keep_file_normals() {
        const auto extreme = [](const glm::dvec3 &n) { return !(largest_part(n) > 1e-18 && largest_part(n) < 1e18); };
        if (flat_.empty() && std::ranges::none_of(file_normals_, extreme)) {
            return;
        }
        std::vector<glm::vec3> computed(positions_.size(), glm::vec3(0));
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            const glm::vec3 p(positions_[a]);
            const glm::vec3 face =
                glm::normalize(glm::cross(glm::vec3(positions_[b]) - p, glm::vec3(positions_[c]) - p));
            for (const std::uint32_t corner : {a, b, c}) {
                computed[corner] += face;
            }
        };
        for (const glm::uvec3 &t : mesh_.triangles) {
            add(corners_[t.x][0], corners_[t.y][0], corners_[t.z][0]);
        }
        for (const auto &t : flat_) {
            add(t[0], t[1], t[2]);
        }
        for (const Corner &corner : corners_) {
            mesh_.file_normals.push_back(corner[2] != none ? glm::vec3(file_normals_[corner[2]]) : computed[corner[0]]);
        }
    }

    /// Of each position: the sum of its triangles' area vectors, made unit. Where they cancel (two faces back to back),
    /// the first triangle's normal, so that no normal is zero.
    [[nodiscard]] std::vector<glm::dvec3> smooth_normals() const {
        std::vector<glm::dvec3> sums(positions_.size(), glm::dvec3(0));
        std::vector<glm::dvec3> firsts = sums;
        std::vector<double> totals(positions_.size(), 0);
        for (const glm::uvec3 &triangle : mesh_.triangles) {
            const std::array<Corner, 3> corners{corners_[triangle.x], corners_[triangle.y], corners_[triangle.z]};
            const glm::dvec3 area = area_vector(corners[0], corners[1], corners[2]);
            for (const Corner &corner : corners) {
                sums[corner[0]] += area;
                totals[corner[0]] += largest_part(area);
                if (firsts[corner[0]] == glm::dvec3(0)) {
                    firsts[corner[0]] = area;
                }
            }
        }
        for (std::size_t i = 0; i < sums.size(); ++i) {
            // 1e-12: below this share of what was added, a sum is rounding error.
            const bool cancelled = largest_part(sums[i]) <= 1e-12 * totals[i];
            sums[i] = unit(cancelled ? firsts[i] : sums[i]);
        }
        return sums;
    }
};

} // namespace

Mesh read_obj(std::string_view text, std::string_view name) {
    Mesh mesh = ObjReader(text, name).read();
    summarise(mesh);
    if (const std::string note = winding_note(mesh); !note.empty()) {
        fmt::print(stderr, "note: {}: {}\n", name, note);
    }
    return mesh;
}

} // namespace sandbox
