#pragma once

#include "image/image.h"
#include "reference/branches.h"
#include "reference/parallel.h"
#include "scene/resources.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

/// The truth: a scene under a technique in double, on the CPU, without OpenGL.
namespace sandbox {

/// The triangles that OpenGL gets, or the shapes they stand for.
enum class Surface { mesh, analytic };

struct ReferenceFrame {
    Size size;
    std::vector<glm::dvec3> color;         ///< linear RGB, row 0 at the top
    std::vector<std::uint32_t> object_ids; ///< 0 background, i + 1 objects[i]
    /// 1 where a pixel's centre lies within 1/128 pixel of an edge between triangles, or another surface lies within
    /// the depth buffer's resolution: OpenGL may see the neighbour.
    std::vector<std::uint8_t> edge;
    /// 1 where `edge` says that another object may be seen and nothing else: the colour of this one is in no doubt.
    std::vector<std::uint8_t> rival;
    /// 1 where the equation jumps (gate, hard cone, checker cell, N turned under facing=view) within 1/128 pixel or
    /// within float32 rounding of what decides it, and what jumps adds light.
    std::vector<std::uint8_t> jump;
    /// 1 where float32 keeps too little of the direction to a light, or of a normal whose corners' normals cancel, and
    /// what depends on it adds light.
    std::vector<std::uint8_t> rounding;
    double milliseconds = 0;

    void mark(std::size_t pixel, const reference::PixelMasks &masks) {
        jump[pixel] = masks.jump ? 1 : 0;
        rounding[pixel] = masks.rounding ? 1 : 0;
    }
};

/// One sample at each pixel's centre. technique.program changes nothing here, and technique.power
/// only under precision=medium, where this is the twin in half (reference/medium_stage.h). The same inputs give
/// the same bits on any number of cores. Throws InputError for Surface::analytic with an OBJ, with an object flattened
/// by a scale of 0, or with a technique that needs vertices; Cancelled if progress says stop.
ReferenceFrame render_reference(const Scene &scene, const std::vector<ObjectResources> &resources,
                                const Technique &technique, Size size, Surface surface = Surface::mesh,
                                const Progress &progress = {});

/// The same picture rounded to float32.
Frame to_frame(const ReferenceFrame &frame);

/// The colours of the mesh alone, likewise, and sooner: masks cost more than colours.
/// `high`: what is declared highp under precision=medium.
Image reference_colors(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &technique,
                       Size size, const reference::HighValues &high = {});

/// Every intermediate at one pixel.
struct PixelProbe {
    std::size_t object = 0;   ///< in scene.objects
    std::size_t triangle = 0; ///< in its mesh; 0 for an analytic surface
    glm::dvec3 position{0};   ///< world space, as lit (position=w0 moves it)
    glm::dvec3 normal{0};
    glm::dvec3 view{0};
    glm::dvec3 base{1};
    std::vector<reference::LightProbe> lights; ///< those switched on
    glm::dvec3 color{0};                       ///< what render_reference gives there
    bool edge = false;
    bool jump = false;
    bool rounding = false;
    double doubt = 0; ///< by how much a channel may differ for these two reasons, at most
    /// How far the colour moves where the triangle moves in the window by 2^-22 of the picture's longer side, along
    /// each axis, as float32 may move it. Slivers and sharp highlights magnify that. 0 for an analytic surface.
    double window_rounding = 0;
};

/// Every intermediate of pixel (x, y), row 0 at the top; nothing for the background. The light terms are those of the
/// equation at that very point (under flat: at the triangle's centroid); under per-vertex the colour is interpolated
/// between vertices and need not be their sum. Throws as render_reference does.
std::optional<PixelProbe> probe_pixel(const Scene &scene, const std::vector<ObjectResources> &resources,
                                      const Technique &technique, Size size, int x, int y,
                                      Surface surface = Surface::mesh);

/// The colours of row y, 0 at the top, as render_reference gives them; nothing for the background. Some milliseconds:
/// the row alone is shaded. Throws as render_reference does.
std::vector<std::optional<glm::dvec3>> reference_row(const Scene &scene, const std::vector<ObjectResources> &resources,
                                                     const Technique &technique, Size size, int y,
                                                     Surface surface = Surface::mesh);

} // namespace sandbox
