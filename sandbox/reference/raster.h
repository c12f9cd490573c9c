#pragma once

#include "image/image.h"
#include "scene/mesh.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

/// Which triangle each pixel sees, in double. Triangles are never cut: in homogeneous coordinates a triangle that
/// crosses the eye's plane still has three edge functions, and near and far are tested per sample.
namespace sandbox::reference {

/// A pixel whose centre lies this near to an edge, or to where the equation takes another branch, is left out of error
/// figures. OpenGL snaps vertices to sub-pixels (1/256 pixel, so a centre moves against an edge by up to 1/362
/// pixel) and places its samples in float32; this is a little more than twice that.
constexpr double edge_width = 1.0 / 128;

/// A vertex in homogeneous pixels: (x w, y w, w) with x to the right, y down from the top-left corner, w the distance
/// along the camera's axis (negative behind it); of an orthographic camera 1.
using Corner = glm::dvec3;
using Triangle = std::array<Corner, 3>;

/// The mesh of one object as the camera sees it.
struct RasterObject {
    std::vector<Corner> corners; ///< one per vertex
    const std::vector<glm::uvec3> *triangles = nullptr;
    /// Which triangles are skipped as the inside of a closed mesh: those whose corners run clockwise on the screen (1),
    /// counter-clockwise (-1), or none (0).
    int hidden = 0;
    /// One per vertex, linear: 1 at near, 0 at far; of an orthographic camera, else empty.
    std::vector<double> nearness{};
    /// ObjectResources::window_grid; only of triangles that near and far do not cut, for a cut has vertices of its own.
    int window_grid = 0;
    double near = 0, far = 0; ///< of a perspective camera

    [[nodiscard]] Triangle triangle(std::size_t index) const;
};

/// What the centre of one pixel sees.
struct Hit {
    std::uint32_t object = 0; ///< 0 background, i + 1 objects[i]
    std::uint32_t triangle = 0;
    double inverse_w =
        0; ///< 1 / distance along the camera's axis; linear nearness under an orthographic camera; 0 for the background
    double beside = 0;     ///< the largest inverse_w of a triangle that misses the centre by less than edge_width
    bool tie = false;      ///< another triangle lies within float32 depth resolution: OpenGL may pick that one
    double resolution = 0; ///< two values of inverse_w that are nearer to each other may come out in either order
    bool own_tie = false;  ///< it may be one of the same object, which no object id tells
};

/// How the triangle's corners run on the screen: 1 clockwise, -1 counter-clockwise, 0 seen edge-on.
double orientation(const Triangle &triangle);

/// Perspective-correct weights of a triangle's corners at the point (x, y) in pixels; they sum to 1.
glm::dvec3 weights_at(const Triangle &triangle, double x, double y);

/// The largest term, at least 1, of a sum that yields a weight at (x, y): a rasteriser starts at the window's corner
/// and adds slopes, so float32 rounds weights of a triangle that is small against the window by this many times as
/// much.
double weights_before_cancelling(const Triangle &triangle, double x, double y);

/// True if the point lies within edge_width of one of the triangle's edges (the lines through its corners).
bool near_edge(const Triangle &triangle, double x, double y);

/// What of the axis is drawn, and how a depth buffer over it tells near from far.
struct DepthRange {
    double near, far;    ///< distances along the camera's axis, both inclusive
    bool linear = false; ///< of an orthographic camera: depth is the distance itself, not its reciprocal
    bool deep = false;   ///< OpenGL's depth is the logarithm of the distance

    explicit DepthRange(const Camera &camera, bool is_deep = false)
        : near(camera.near_plane), far(camera.far_plane), linear(is_orthographic(camera)), deep(is_deep) {}
    DepthRange(double near_plane, double far_plane, bool is_deep = false)
        : near(near_plane), far(far_plane), deep(is_deep) {}
    /// The inverse_w of the near plane.
    [[nodiscard]] double nearest() const { return linear ? 1 : 1 / near; }
    [[nodiscard]] bool holds(double inverse_w) const {
        return linear ? inverse_w >= 0 && inverse_w <= 1 : inverse_w * near <= 1 && inverse_w * far >= 1;
    }
    /// Hit::resolution at `inverse_w` on a triangle whose corners' is at most `highest`.
    [[nodiscard]] double resolution(double inverse_w, double highest) const;
};

/// Draws in object order, then triangle order; the nearer wins, the first drawn on a tie. Edges follow the top-left
/// rule, so that triangles that share an edge cover each pixel once.
class Rasteriser {
  public:
    /// Keeps a reference to `objects`.
    Rasteriser(const std::vector<RasterObject> &objects, Size size, const DepthRange &depth);

    /// Rows are drawn in bands, each on its own (so bands may be drawn by any thread).
    [[nodiscard]] std::size_t bands() const { return bins_.size(); }
    [[nodiscard]] std::size_t band_of(int row) const;
    [[nodiscard]] int first_row(std::size_t band) const;
    /// All pixels of a band, row by row.
    [[nodiscard]] std::vector<Hit> draw(std::size_t band) const;

    /// True if a triangle that misses the centre by less than edge_width is as near as what was hit, or nearer.
    [[nodiscard]] bool beside_wins(const Hit &hit) const;

  private:
    struct Entry {
        std::uint32_t object;
        std::uint32_t triangle;
    };
    /// Pixels, both ends included.
    struct Box {
        int left, right, top, bottom;
    };
    [[nodiscard]] std::optional<Box> bounds(const Triangle &triangle) const;
    void draw_triangle(const Entry &entry, int first_row, std::span<Hit> hits) const;

    const std::vector<RasterObject> &objects_;
    Size size_;
    DepthRange depth_;
    std::vector<std::vector<Entry>> bins_;
};

} // namespace sandbox::reference
