#pragma once

#include "measure/metrics/metrics.h"
#include "teach/claims.h"
#include "teach/lesson.h"

#include <glm/vec4.hpp>
#include <optional>
#include <variant>
#include <vector>

/// The pictures that claims compare.
namespace sandbox {

using Picture = std::variant<Frame, ReferenceFrame>; ///< in float32, or in double

/// The technique of a picture; `other` is the picture that it is judged with or judges.
Technique technique_of(const PictureSource &source, const LessonStep &step, const Technique &other);
/// ... and the factor on its meshes: B's for `right`, A's for the others, unless they judge B.
double mesh_factor_of(const PictureSource &source, const LessonStep &step, const PictureSource &other);

/// The pictures of one step, each drawn once, as claims ask for them.
class PictureShelf {
  public:
    explicit PictureShelf(const LessonDraw &draw) : draw_(draw) {}
    /// Of a colour, the object ids are those of the technique's picture.
    Picture picture(const PictureSource &source, const Technique &technique, const Scene &scene, Size size);

  private:
    enum class Hand { renderer, reference, analytic, textbook };
    struct Entry {
        Hand hand;
        Technique technique;
        Size size;
        Scene scene;
        Picture picture;
    };
    static Hand hand_of(PictureSource::Kind kind);
    [[nodiscard]] Picture draw(Hand hand, const Technique &technique, const Scene &scene, Size size) const;

    const LessonDraw &draw_;
    std::vector<Entry> drawn_; ///< at most most_kept
};

/// The part of a picture within shares left, top, right, bottom: at least one pixel.
Picture cropped(Picture picture, const std::optional<glm::dvec4> &region);

Metrics compare_pictures(const Picture &left, const Picture &right, Flip flip);
/// In any bit of any channel; pictures in double are rounded first.
std::size_t differing_bits(const Picture &left, const Picture &right);
/// The largest channel of the pixels that show an object; infinite if one is not finite.
double brightest(const Picture &picture);

} // namespace sandbox
