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

/// The columns where the second and third views begin.
std::vector<int> splits_of(const PictureOptions &options) {
    if (options.layout == Layout::wipe) {
        return {split_column(options.size, options.divider)};
    }
    std::vector<int> splits;
    int column = 0;
    if (columns_of(options.layout) > 1) {
        for (const Size &view : view_sizes(options.layout, options.size)) {
            splits.push_back(column += view.width);
        }
        splits.pop_back();
    }
    return splits;
}

/// One for each view, then a difference's caption.
std::vector<std::string> label_texts(const PictureOptions &options) {
    const std::string left = options.textbook_left ? textbook_name(options.left) : to_string(options.left);
    if (options.layout == Layout::single) {
        return {left};
    }
    std::vector<std::string> texts{"A  " + left, "B  " + to_string(options.right)};
    if (options.layout == Layout::three_up) {
        texts.push_back(fmt::format("truth: {}, in double precision", to_string(truth_of(options.left))));
    } else if (options.layout == Layout::difference) {
        texts.push_back(difference_caption(options.gain));
    }
    return texts;
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

Technique truth_of(const Technique &technique) { return {.frequency = Frequency::per_pixel, .model = technique.model}; }

Image draw_picture(const Scene &scene, const PictureOptions &options, const Painters &painters) {
    const std::vector<Size> sizes = view_sizes(options.layout, options.size);
    std::vector<Image> views;
    for (const Size &size : sizes) {
        switch (views.size()) {
        case 0:
            views.push_back((options.textbook_left ? painters.textbook : painters.draw)(scene, options.left, size));
            break;
        case 1:
            views.push_back(painters.draw(scene, options.right, size));
            break;
        default:
            views.push_back(painters.truth(scene, truth_of(options.left), size));
        }
    }
    return compose(options.layout, views, options.divider);
}

ByteImage show_picture(const Image &linear, const PictureOptions &options) {
    ByteImage shown = to_display(options.layout == Layout::difference ? magnified(linear, options.gain) : linear,
                                 options.display, options.exposure);
    const std::vector<int> splits = splits_of(options);
    for (const int split : splits) {
        if (options.layout == Layout::wipe || options.labels) {
            draw_divider(shown, split);
        }
    }
    if (options.labels) {
        draw_labels(shown, options.layout, splits, label_texts(options));
    }
    return shown;
}

} // namespace sandbox
