#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

namespace sandbox {

/// A corner of a face: indices into the file's lists.
struct ObjCorner {
    std::uint32_t v = 0;
    std::uint32_t vt = no_index;
    std::uint32_t vn = no_index;

    static constexpr std::uint32_t no_index = 0xffffffffU;
    /// Of vn: an index that names no line (0, or one counted backward where none came before).
    static constexpr std::uint32_t bad_index = 0xfffffffeU;
    static constexpr std::uint32_t most = 0xfffffff0U;
    bool operator==(const ObjCorner &) const = default;
};

/// A smoothing group: faces share their computed normals with those of the same group alone.
using SmoothingGroup = std::uint32_t;
constexpr SmoothingGroup unsmoothed = 0; ///< s off, s 0
constexpr SmoothingGroup ungrouped = 1;  ///< before any s: smooth

/// Of 32 bits each: a file has at most largest_file bytes, and millions of faces.
struct ObjFace {
    std::uint32_t first_corner = 0;
    std::uint32_t corner_count = 0;
    SmoothingGroup group = ungrouped;
    std::uint32_t line = 0;
    std::uint32_t material = 0; ///< in ObjFaces::materials
};

/// What an OBJ text lists, as it stands there.
struct ObjFaces {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> colors; ///< of each position, white where it has none of use; empty: none has one
    std::vector<glm::dvec2> uvs;
    std::vector<glm::dvec3> normals; ///< of any length; all NaN where a part is not finite
    std::vector<ObjCorner> corners;  ///< of all faces
    std::vector<ObjFace> faces;
    std::vector<std::string> materials{""}; ///< names after usemtl; the first: before any

    [[nodiscard]] std::span<const ObjCorner> corners_of(const ObjFace &face) const {
        return std::span(corners).subspan(face.first_corner, face.corner_count);
    }
    /// A normal that can be made unit.
    [[nodiscard]] bool has_normal(const ObjCorner &corner) const;
};

} // namespace sandbox
