#pragma once

#include "certificate/choice.h"
#include "render/display_pass.h"
#include "render/own_process.h"
#include "render/renderer.h"
#include "ui/session/findings.h"
#include "ui/session/session.h"

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sandbox {

/// One side's picture, as last drawn.
struct PaintedView {
    unsigned texture = 0; ///< bottom row first; 0: no picture
    Size size;
    unsigned nonfinite = 0; ///< pixels that are NaN or infinite; magenta in the picture
    std::string error;      ///< why there is none
    std::string warning;    ///< there is one, but a shader does not build
};

/// Comes as a finished picture, made aside: a textbook's, by the processor, or own shading's, by a process of its own.
inline bool comes_finished(bool textbook, const Technique &technique) {
    return textbook || technique.model == Model::own;
}

/// A side's picture that would keep the window waiting: triangles must be chosen or a program be built first, or it
/// comes finished.
struct SlowPicture {
    bool right = false, textbook = false;
    Scene scene;
    Technique technique;
    Size size;
    std::optional<DisplayMap> shown;         ///< drawn as a screen shows it; none: as linear light
    std::vector<Features> programs{};        ///< those that are missing
    std::vector<ObjectResources> unchosen{}; ///< ... once the triangles of `auto` are chosen
    Overlays overlays{};                     ///< on surfaces, of linear light
    bool difference = false;                 ///< ... in a difference
    [[nodiscard]] bool finished() const { return comes_finished(textbook, technique); }
};

/// What was made aside of one: the picture, if it comes finished, or why there is none; the triangles, if they are
/// asked for.
struct MadePicture {
    Image image;
    std::string failure;
    std::optional<certificate::Choice> choice{};
};

/// All that a side's float picture depends on.
struct ViewKey {
    Scene scene;
    Technique technique;
    Size size;
    bool textbook = false; ///< on the processor
    Overlays overlays;     ///< on surfaces
    int shaders = 0;       ///< counts reloads
    bool operator==(const ViewKey &) const = default;
    [[nodiscard]] bool finished() const { return comes_finished(textbook, technique); }
};
using ViewKeys = std::array<ViewKey, 2>; ///< of A and B

/// Both pictures with samples_at_rest samples a pixel.
struct SmoothPictures {
    ViewKeys of;
    std::array<std::shared_ptr<const Image>, 2> means;
};

/// Draws the two pictures, each only if something in it has changed.
class ViewPainter {
  public:
    ViewPainter(const Assets &assets, const Assets &shaders);

    /// Updates both sides and, if the layout shows it, their difference. A side whose picture is slow keeps its last
    /// one until that has been made aside. `moving`: something is dragged or plays.
    void paint(const Session &session, Size each, bool moving);

    /// What paint() would wait for in the lesson's next step, so that it can be made ahead; nothing: the side can be
    /// drawn at once.
    [[nodiscard]] std::optional<SlowPicture> slow_ahead(const Session &session, bool right);

    /// There is nobody to make pictures aside: the window waits for programs and choices.
    void wait_for_no_program() { waits_ = false; }
    /// What paint() waits for; null: nothing.
    [[nodiscard]] const SlowPicture *awaited() const;
    /// It has been made aside, as far as that could be: its programs are in the driver's cache now.
    void made_aside(const SlowPicture &picture, MadePicture made);

    [[nodiscard]] const PaintedView &view(bool right) const { return sides_[right ? 1 : 0].shown; }
    /// All that findings about what is shown depend on, the views being of the size that they were last painted in.
    [[nodiscard]] SidesShown sides_shown(const Document &document) const;
    /// What has been found out; dropped when something else is shown. Null: nothing yet.
    void show_findings(std::shared_ptr<const Findings> findings) { findings_ = std::move(findings); }
    [[nodiscard]] const Findings *findings() const { return findings_.get(); }
    /// The pictures that are to be smoothed while nothing moves; none where what is shown is measured by single
    /// samples, as a difference, a loupe and a textbook's picture are.
    [[nodiscard]] std::optional<ViewKeys> smooth_wanted(const Session &session) const;
    /// Stand in for the pictures that they are of. Null: there are none yet.
    void show_smooth(std::shared_ptr<const SmoothPictures> smooth) { smooth_ = std::move(smooth); }
    /// In place of a side's picture: which pixels errors leave out; 0: not known, or not asked for.
    [[nodiscard]] unsigned mask_texture(bool right) const;
    /// The reference of a side's model; 0: not known, or not asked for.
    [[nodiscard]] unsigned truth_texture(bool right) const;
    /// One row of a side's picture without overlays, from the top, in linear colour; empty: there is none.
    [[nodiscard]] Image row(bool right, int y);
    /// 0 until both pictures are there.
    [[nodiscard]] unsigned difference_texture() const { return difference_ ? difference_->texture() : 0; }
    /// The largest difference of any channel, from the last measure_difference(); infinite if a pixel is not finite.
    [[nodiscard]] double largest_difference() const { return largest_difference_; }
    /// Reads both pictures back if they have changed; slow, so not while something is dragged.
    void measure_difference();

    /// Grows whenever a texture that is shown changes.
    [[nodiscard]] unsigned long changes() const { return changes_; }

    /// Triangles of each object of a side; empty if a mesh cannot be read.
    [[nodiscard]] std::vector<std::size_t> triangles(bool right) const;
    /// Of both sides' scenes. Throws InputError.
    [[nodiscard]] std::array<std::vector<ObjectResources>, 2> resources_of(const SidesShown &shown);

    /// Do A and B draw the same picture of the scene, whatever is ticked?
    [[nodiscard]] bool same_picture(const Document &document);

    [[nodiscard]] Renderer &renderer() { return renderer_; }
    /// --shaders DIR: true if a file there has changed; everything is then redrawn.
    bool reload_changed_shaders();

  private:
    struct Side {
        std::optional<ViewKey> drawn;          ///< also if that failed: it is not retried until something changes
        bool light = false;                    ///< drawn into `target`
        std::optional<DisplayMap> displayed;   ///< none: not yet
        std::optional<ScreenTarget> screen;    ///< drawn as the screen shows it, where nothing reads linear light,
        std::optional<Target> target;          ///< or else linear light,
        std::optional<Target> plain;           ///< `target` without the overlays drawn over it, once a row is asked for
        std::optional<DisplayTexture> display; ///< and what the screen shows of that
        PaintedView shown;
        std::vector<ObjectResources> resources; ///< held, so that the other side's meshes do not evict them
        std::optional<SlowPicture> awaited;
        [[nodiscard]] bool has_light() const { return light && shown.texture != 0; }
        struct Finished {
            ViewKey asked;       ///< the last one that was made, or failed
            std::string failure; ///< of it; empty: none
            ViewKey of;          ///< what `image` shows: the last one that did not fail
            Image image;         ///< empty: none yet
        };
        std::optional<Finished> finished; ///< without overlays
    };

    /// A picture made aside, on the graphics card.
    struct Uploaded {
        std::shared_ptr<const Image> image;
        Target target;
        DisplayTexture display;
        std::optional<DisplayMap> displayed;
        explicit Uploaded(Size size) : target(size), display(size) {}
    };
    struct Masks {
        std::shared_ptr<const Findings> findings;
        DisplayMap map;
        DisplayTexture texture;
    };

    bool paint_side(Side &side, const ViewKey &wanted, const DisplayMap &display, bool light, bool moving);
    [[nodiscard]] std::optional<SlowPicture> slow_picture(const Side &side, const ViewKey &key,
                                                          const std::optional<DisplayMap> &shown, bool moving);
    void draw_light(Side &side, const ViewKey &key, const DisplayMap &display);
    void draw_shown(Side &side, const ViewKey &key, const DisplayMap &display);
    [[nodiscard]] bool reads_light(const ViewSettings &view) const;
    bool upload(std::unique_ptr<Uploaded> &uploaded, const std::shared_ptr<const Image> &image,
                const DisplayMap &display);
    void paint_smooth(bool right, const DisplayMap &display);
    void paint_masks(bool right, bool wanted, const DisplayMap &display);
    unsigned display_side(Side &side, const DisplayMap &display);
    void paint_difference(const ViewSettings &view, bool changed);
    [[nodiscard]] const Target *target_of(DifferenceOf of, bool second) const;

    OwnProcess own_; ///< draws own shading for the renderer
    Renderer renderer_;
    DisplayPass display_pass_;
    std::array<Side, 2> sides_;
    std::shared_ptr<const Findings> findings_;
    std::shared_ptr<const SmoothPictures> smooth_;
    std::array<std::unique_ptr<Uploaded>, 2> truths_, smoothed_;
    std::array<std::unique_ptr<Masks>, 2> masks_;
    std::optional<DisplayTexture> difference_;
    double difference_gain_ = 0;
    DifferenceOf difference_of_ = DifferenceOf::a_b;
    bool measured_ = false;
    double largest_difference_ = 0;
    int reloads_ = 0;
    std::set<Features> built_aside_;
    bool waits_ = true;
    unsigned long changes_ = 0;
};

} // namespace sandbox
