#pragma once

#include "measure/diagnosis/diagnosis.h"
#include "shading/own_shader.h"
#include "shading/parts.h"
#include "teach/marking/faults.h"
#include "teach/marking/judge.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Marks answers to one exercise. Knows no OpenGL.
namespace sandbox {

/// How pictures are drawn: by the renderer, or by fakes in a test.
struct MarkDraw {
    using Picture = std::function<Frame(const Scene &, const Technique &, Size, bool object_ids)>;
    DiagnosisDraw trusted; ///< the program's own shading
    /// Own text, which nobody vouches for. Throws InputError with a sentence where the answer fails.
    Picture own;
    const ShaderParts *parts = nullptr;
};

/// Draws with render/'s Renderer, which this room cannot name and which must outlive what is returned; it draws own
/// shading as it was told to.
template <typename Renderer> MarkDraw marks_drawn_by(Renderer &renderer) {
    return {diagnosis_drawn_by(renderer),
            [&renderer](const Scene &scene, const Technique &technique, Size size, bool object_ids) {
                return renderer.render(scene, technique, size, object_ids);
            },
            &renderer.parts()};
}

/// What an answer got.
struct Mark {
    Judgement judgement;       ///< empty where the answer was refused, or where the points cannot be given
    std::vector<Fault> faults; ///< that are known, at most one a term
    std::string refused;       ///< why it was not marked; empty: it was
    bool unknown = false;      ///< a picture that nothing explains: its points cannot be given
    bool of_picture = false;
    /// Of the first scene, as shown; empty where nothing could be drawn.
    Image student, truth;
};

class Marker {
  public:
    /// Both must outlive this.
    Marker(const Exercise &exercise, const MarkDraw &draw);
    ~Marker();
    Marker(const Marker &) = delete;
    Marker &operator=(const Marker &) = delete;

    /// What the answer fails at, it is refused for.
    Mark mark_own(const OwnShader &text);
    /// A picture of the first scene; one that is too large is refused.
    Mark mark_picture(const Observed &picture);
    /// Points and terms of an answer that could not be read.
    [[nodiscard]] Mark refuse(std::string why) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The most pixels of a picture that is handed in: 1920 x 1200.
constexpr int most_handed_in_pixels = 1920 * 1200;

} // namespace sandbox
