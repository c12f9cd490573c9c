#pragma once

#include "capture/layout.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <functional>
#include <string>
#include <string_view>

/// A picture of a scene for a file: `capture` and the window's capture key both make it.
namespace sandbox {

/// Draws a view: the renderer, or a fake in a test.
using DrawView = std::function<Image(const Scene &, const Technique &, Size)>;
/// Who draws what.
struct Painters {
    DrawView draw;
    DrawView textbook; ///< textbook_picture()
    DrawView truth;    ///< the reference
};
/// The technique of the reference that a side is judged by: its model, per pixel, every fault off.
Technique truth_of(const Technique &technique);

/// "linear" or "srgb". Throws InputError.
Display parse_display(std::string_view text);
std::string_view to_string(Display display);

struct PictureOptions {
    Layout layout = Layout::single;
    Technique left; ///< Layout::single has this one only
    Technique right;
    bool textbook_left = false; ///< the left view is textbook_picture() by the left technique's model
    Size size{1280, 720};       ///< of the whole picture
    Display display = Display::linear;
    double exposure = 1;
    double gain = 1;      ///< factor on a difference in a PNG
    double divider = 0.5; ///< the left view's share of a wipe's width
    bool labels = false;
    std::string view; ///< the named view that the camera came from, for the record
    bool operator==(const PictureOptions &) const = default;
};

/// How a textbook's picture is labelled: "textbook float32/phong". It depends on the technique's model alone.
std::string textbook_name(const Technique &technique);

/// Linear RGB, as a PFM holds it. A difference is left - right, without gain. The third view of a three-up is the truth
/// of the left technique.
Image draw_picture(const Scene &scene, const PictureOptions &options, const Painters &painters);

/// The picture as a PNG holds it: `linear` (from draw_picture) through gain * |difference|, exposure and the display's
/// curve, then a wipe's divider, then labels.
ByteImage show_picture(const Image &linear, const PictureOptions &options);

} // namespace sandbox
