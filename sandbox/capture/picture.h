#pragma once

#include "capture/layout.h"
#include "capture/marks.h"
#include "capture/masks.h"
#include "scene/mesh_factor.h"
#include "scene/overlays.h"
#include "scene/scene.h"
#include "shading/technique.h"
#include "words/words.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

/// A picture of a scene for a file: `capture` and the window's capture key both make it.
namespace sandbox {

/// Draws a view: the renderer, or a fake in a test.
using DrawView = std::function<Image(const Scene &, const Technique &, Size)>;
using ProbeView = std::function<std::optional<PixelProbe>(const Scene &, const Technique &, Size, int x, int y)>;
/// `textbook`: the view is textbook_picture().
using JudgeView =
    std::function<JudgedView(const Scene &, const Technique &, const Technique &truth, Size, bool textbook)>;
/// Who draws what. `draw` and `textbook` draw the overlays on surfaces, too, that the picture has.
struct Painters {
    DrawView draw;
    DrawView textbook; ///< textbook_picture()
    DrawView truth;    ///< the reference
    ProbeView probe{}; ///< probe_pixel(); for marks alone
    JudgeView judge{}; ///< judge_view(); for masks alone
};
/// The two pictures of a difference, as its scale names them: "A" and "truth".
std::pair<std::string, std::string> names_of(const Words &words, DifferenceOf of);
/// "not finite", "no pixel differs", "largest 0.25".
std::string difference_text(const Words &words, double largest);
/// "truth  Phong, per pixel, in double": over a reference, on a side's mesh.
std::string truth_label(const Words &words, const Technique &truth, double mesh_factor = 1);
/// As labels have it: ", mesh x 1/4"; empty for 1.
std::string mesh_factor_note(const Words &words, double factor);
/// The technique of the reference that a side is judged by: its model or, of own shading, which has no reference, that
/// of the other side; per pixel, every fault off.
Technique truth_of(const Technique &technique, const Technique &other);

/// "linear" or "srgb". Throws InputError.
Display parse_display(std::string_view text);
std::string_view to_string(Display display);
/// "a-b", "a-reference", "b-reference".
std::string_view to_string(DifferenceOf of);
/// Throws InputError listing the names.
DifferenceOf parse_difference_of(std::string_view text);

/// A single view of two techniques, of which the window shows one at a time.
enum class FlipSide { none, a, b };

struct PictureOptions {
    Layout layout = Layout::single;
    Technique left; ///< Layout::single without flip has this one only
    Technique right;
    MeshFactors mesh_factors{1, 1}; ///< on the meshes of the left and the right view
    bool textbook_left = false;     ///< the left view is textbook_picture() by the left technique's model
    FlipSide flip = FlipSide::none; ///< Layout::single: which of the two
    Size size{1280, 720};           ///< of the whole picture
    Display display = Display::linear;
    double exposure = 1;
    double gain = 1; ///< factor on a difference in a PNG
    DifferenceOf difference_of = DifferenceOf::a_b;
    double divider = 0.5; ///< the left view's share of a wipe's width
    int samples = 1;      ///< a pixel of the views, for a PNG that is no difference
    Overlays drawn_over;
    bool masks = false; ///< in a PNG of views, not of a difference; samples are 1 then
    bool labels = false;
    std::string language{languages.front()}; ///< of all that is written in the picture
    Marks marks;                             ///< in a PNG
    std::string view;                        ///< the named view that the camera came from, for the record
    bool operator==(const PictureOptions &) const = default;
};

/// How a textbook's picture is labelled: "textbook float32/phong". It depends on the technique's model alone.
std::string textbook_name(const Technique &technique);

/// The data, as a PFM holds it: linear RGB, `options.size` for the views alone. A difference is the first picture - the
/// second, without gain. The third view of a three-up is the truth of the left technique.
Image draw_picture(const Scene &scene, const PictureOptions &options, const Painters &painters);

/// The picture as a PNG holds it: exposure and the display's curve, marks, dividers, labels in a strip above the views;
/// a difference in its colours, with its scale in a strip below.
ByteImage show_picture(const Scene &scene, const PictureOptions &options, const Painters &painters);

/// What the strips of a PNG leave to its views. Strips that would take more than a third of the height are left out.
Size room_for_views(const PictureOptions &options);
/// The size of a PNG that leaves `room` to its views.
Size size_around(PictureOptions options, Size room);

} // namespace sandbox
