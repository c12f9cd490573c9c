#include "capture/picture.h"

#include "capture/labels.h"
#include "image/error.h"

#include <cmath>
#include <fmt/format.h>

namespace sandbox {
namespace {

Image magnified(Image difference, double gain) {
    const auto g = static_cast<float>(gain);
    for (glm::vec4 &p : difference.pixels) {
        p = {g * std::abs(p.r), g * std::abs(p.g), g * std::abs(p.b), 1};
    }
    return difference;
}

std::string difference_caption(double gain) {
    return gain == 1 ? "|A - B|" : fmt::format("{:g} |A - B|", gain); // "4 |A - B|"
}

} // namespace

Display parse_display(std::string_view text) {
    if (text != "linear" && text != "srgb") {
        throw InputError("expected linear or srgb, got '{}'", text);
    }
    return text == "srgb" ? Display::srgb : Display::linear;
}

std::string_view to_string(Display display) { return display == Display::srgb ? "srgb" : "linear"; }

std::string textbook_name(const Technique &technique) {
    const std::string name = to_string(Technique{.model = technique.model});
    return "textbook float32" + name.substr(name.find('/'));
}

Image draw_picture(const Scene &scene, const PictureOptions &options, const DrawView &draw, const DrawView &textbook) {
    const ViewSizes sizes = view_sizes(options.layout, options.size);
    Image left = (options.textbook_left ? textbook : draw)(scene, options.left, sizes.left);
    if (options.layout == Layout::single) {
        return left;
    }
    return compose(options.layout, left, draw(scene, options.right, sizes.right), options.divider);
}

ByteImage show_picture(const Image &linear, const PictureOptions &options) {
    ByteImage shown = to_display(options.layout == Layout::difference ? magnified(linear, options.gain) : linear,
                                 options.display, options.exposure);
    const int split = split_column(shown.size, options.layout == Layout::wipe ? options.divider : 0.5);
    if (options.layout == Layout::wipe) {
        draw_divider(shown, split);
    }
    if (options.labels) {
        const std::string left = options.textbook_left ? textbook_name(options.left) : to_string(options.left);
        draw_labels(shown, options.layout, split, left, to_string(options.right), difference_caption(options.gain));
    }
    return shown;
}

} // namespace sandbox
