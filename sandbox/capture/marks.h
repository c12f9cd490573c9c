#pragma once

#include "capture/strokes.h"
#include "image/image.h"
#include "reference/reference.h"
#include "scene/light_gizmos.h"
#include "scene/scene.h"
#include "shading/technique.h"
#include "words/words.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

/// What may be drawn over every view of a picture.
namespace sandbox {

/// Places are shares of a view's width and height, from its upper left corner.
struct Marks {
    std::optional<glm::dvec2> pixel;  ///< of the vectors and the loupe
    bool vectors = false;             ///< a cross at the pixel and, from its point, N, V and every light's L, R or H
    bool loupe = false;               ///< the pixel and its neighbours, magnified, in a corner
    std::optional<double> profile;    ///< a line across, at this share of the height
    std::optional<glm::dvec3> ring{}; ///< where to look: x, y, and the radius as a share of the height
    bool operator==(const Marks &) const = default;
};

struct Arrow {
    glm::dvec2 from, to; ///< places
    Rgb color;
    std::string name;
};
/// The vectors at a pixel as they lie in a view of `aspect` (width / height). `model` says whether R or H is shown.
std::vector<Arrow> arrows_of(const Scene &scene, Model model, const PixelProbe &probe, double aspect);

/// A light over a view.
struct LightMark {
    LightGizmo gizmo;
    Rgb color;
    bool named = false; ///< another light is on
};
std::vector<LightMark> light_marks(const Scene &scene, double aspect);
constexpr double lamp_radius = 0.4; ///< text heights

constexpr int loupe_across = 21; ///< pixels, odd: the probed one is in the middle
/// Is there more room for the loupe on the right of the pixel?
bool loupe_on_the_right(const glm::dvec2 &pixel);

/// Draws the marks over a view, their names in text of `em` pixels, by which the other sizes go; `words` names the
/// lights.
void draw_marks(ByteImage &view, const Words &words, const Marks &marks, const std::vector<Arrow> &arrows, double em,
                const std::vector<LightMark> &lights = {});

} // namespace sandbox
