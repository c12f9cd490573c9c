#pragma once

#include "capture/layout.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <functional>
#include <string>
#include <string_view>

/// A picture of a scene as a file holds it: what `capture` and the window's capture key both make.
namespace sandbox {

/// Draws a view: the renderer, or a fake in a test.
using DrawView = std::function<Image(const Scene &, const Technique &, Size)>;

/// "linear" or "srgb". Throws InputError.
Display parse_display(std::string_view text);
std::string_view to_string(Display display);

struct PictureOptions {
    Layout layout = Layout::single;
    Technique left;  ///< the only one of Layout::single
    Technique right; ///< not used in Layout::single
    /// The left view in a textbook's float32 on the processor, by the left technique's model (textbook_picture()).
    bool textbook_left = false;
    Size size{1280, 720}; ///< of the whole picture
    Display display = Display::linear;
    double exposure = 1;
    double gain = 1;      ///< of a difference that is shown
    double divider = 0.5; ///< of a wipe: the left view's share of the width
    bool labels = false;
    std::string view; ///< name of the view that the scene's camera was taken from, for the record
    bool operator==(const PictureOptions &) const = default;
};

/// What a textbook's picture is called: "textbook float32/phong". It has the technique's model alone.
std::string textbook_name(const Technique &technique);

/// Linear RGB: what a PFM holds. A difference is left - right, without gain. `textbook` draws the left view where that
/// is asked for; `draw` all else.
Image draw_picture(const Scene &scene, const PictureOptions &options, const DrawView &draw,
                   const DrawView &textbook = {});

/// What a PNG holds: `linear` (of draw_picture) through gain * |difference|, exposure and the display's curve, then a
/// wipe's divider, then labels.
ByteImage show_picture(const Image &linear, const PictureOptions &options);

} // namespace sandbox
