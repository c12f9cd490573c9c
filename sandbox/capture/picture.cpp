#include "capture/picture.h"

#include "capture/labels.h"
#include "capture/samples.h"
#include "image/cut_paste.h"
#include "image/difference.h"
#include "image/error.h"
#include "words/row_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <vector>

namespace sandbox {
namespace {

Technique truth_of_side(const PictureOptions &options, bool right) {
    return right ? truth_of(options.right, options.left) : truth_of(options.left, options.right);
}

constexpr std::array<std::string_view, 3> difference_names{"a-b", "a-reference", "b-reference"};

/// In people's words.
std::vector<std::string> label_texts(const PictureOptions &options) {
    const Words words = words_of_labels(options.language);
    const std::string left =
        options.textbook_left ? words.format("label.textbook", title_of(words, model_key, model_key.get(options.left)))
                              : title_of(words, options.left);
    const std::string left_mesh = mesh_factor_note(words, options.mesh_factors[0]);
    const std::string a = "A  " + left + left_mesh;
    const std::string b = "B  " + title_of(words, options.right) + mesh_factor_note(words, options.mesh_factors[1]);
    switch (options.layout) {
    case Layout::single:
        return {options.flip == FlipSide::none ? left + left_mesh : options.flip == FlipSide::a ? a : b};
    case Layout::three_up:
        return {a, b, truth_label(words, truth_of_side(options, false), options.mesh_factors[0])};
    case Layout::difference:
        if (options.difference_of != DifferenceOf::a_b) {
            const bool right = options.difference_of == DifferenceOf::b_truth;
            return {right ? b : a,
                    truth_label(words, truth_of_side(options, right), options.mesh_factors[right ? 1 : 0])};
        }
        break;
    case Layout::side_by_side:
    case Layout::wipe:
        break;
    }
    return {a, b};
}

/// The columns where the second and third views or labels begin.
std::vector<int> splits_of(const PictureOptions &options) {
    if (options.layout == Layout::wipe || options.layout == Layout::difference) {
        return {split_column(options.size, options.layout == Layout::wipe ? options.divider : 0.5)};
    }
    std::vector<int> splits;
    int column = 0;
    for (const Size &view : view_sizes(options.layout, options.size)) {
        splits.push_back(column += view.width);
    }
    splits.pop_back();
    return splits;
}

/// However high the picture is.
Strips wished_strips(const PictureOptions &options) {
    LabelTexts texts;
    texts.labels = options.labels ? label_texts(options) : std::vector<std::string>{};
    texts.splits = options.labels ? splits_of(options) : std::vector<int>{};
    texts.splits_move = columns_of(options.layout) == 1;
    texts.scale = options.layout == Layout::difference;
    return strips_for(options.size.width, texts);
}

Strips strips_of(const PictureOptions &options) {
    Strips strips = wished_strips(options);
    return 3 * (strips.above + strips.below) <= options.size.height ? strips : Strips{};
}

/// One for each view; of a difference, its two pictures.
std::vector<Image> draw_views(const Scene &scene, const PictureOptions &options, Size room, const Painters &painters) {
    const Scene left_scene = with_mesh_factor(scene, options.mesh_factors[0]);
    const Scene right_scene = with_mesh_factor(scene, options.mesh_factors[1]);
    const auto sampled = [&](const DrawView &draw, const Scene &of, const Technique &technique, Size size) {
        return draw_samples(of, size, options.masks ? 1 : options.samples,
                            [&](const Scene &shifted) { return draw(shifted, technique, size); });
    };
    const auto left = [&](Size size) {
        return sampled(options.textbook_left ? painters.textbook : painters.draw, left_scene, options.left, size);
    };
    const auto right = [&](Size size) { return sampled(painters.draw, right_scene, options.right, size); };
    const auto truth = [&](bool of_right, Size size) {
        return sampled(painters.truth, of_right ? right_scene : left_scene, truth_of_side(options, of_right), size);
    };
    const std::vector<Size> sizes = view_sizes(options.layout, room);
    if (options.layout == Layout::single) {
        return {options.flip == FlipSide::b ? right(room) : left(room)};
    }
    if (options.layout == Layout::difference && options.difference_of != DifferenceOf::a_b) {
        const bool of_right = options.difference_of == DifferenceOf::b_truth;
        return {of_right ? right(room) : left(room), truth(of_right, room)};
    }
    std::vector<Image> views{left(sizes[0]), right(sizes[1])};
    if (options.layout == Layout::three_up) {
        views.push_back(truth(false, sizes[2]));
    }
    return views;
}

/// What the views show, with the figures of those that masks are of; the truth has none.
struct ShownViews {
    std::vector<ByteImage> pictures;
    std::vector<Metrics> masked;
};

ShownViews show_views(const std::vector<Image> &views, const Scene &scene, const PictureOptions &options,
                      const Painters &painters) {
    ShownViews shown;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const bool right = i == 1 || options.flip == FlipSide::b;
        shown.pictures.push_back(to_display(views[i], options.display, options.exposure));
        if (options.masks && i < 2) {
            const JudgedView judged = painters.judge(
                with_mesh_factor(scene, options.mesh_factors[right ? 1 : 0]), right ? options.right : options.left,
                truth_of_side(options, right), views[i].size, !right && options.textbook_left);
            shown.pictures.back() = mask_picture(shown.pictures.back(), judged.uses);
            shown.masked.push_back(judged.metrics);
        }
    }
    return shown;
}

/// As compose() does with linear views that are no difference.
void paste_views(ByteImage &picture, const std::vector<ByteImage> &views, const PictureOptions &options, int top) {
    int left = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (options.layout == Layout::wipe && i == 1) {
            const int split = split_column(views[i].size, options.divider);
            paste(picture, cut(views[i], split, 0, {views[i].size.width - split, views[i].size.height}), split, top);
        } else {
            paste(picture, views[i], left, top);
            left += views[i].size.width;
        }
    }
}

/// One legend a view that has masks; a wipe's stand in its halves.
void draw_legends(ByteImage &picture, const std::vector<Metrics> &masked, const PictureOptions &options, int bottom,
                  double text) {
    const Words words = words_of_labels(options.language);
    const std::vector<Size> views = view_sizes(options.layout, options.size);
    const bool wipe = options.layout == Layout::wipe;
    int left = 0;
    for (std::size_t i = 0; i < masked.size(); ++i) {
        const int right = wipe && i == 0 ? options.size.width / 2 : wipe ? options.size.width : left + views[i].width;
        draw_mask_legend(picture, words, masked[i], left, right, bottom, text, wipe && i == 1);
        left = right;
    }
}

/// Over the views, `rows` high, that begin at row `top`; names in text of `text` pixels.
void mark_views(ByteImage &picture, const Scene &scene, const PictureOptions &options, const Painters &painters,
                int top, int rows, double text) {
    if (options.marks == Marks{} && !options.drawn_over.lights) {
        return;
    }
    const Scene left_scene = with_mesh_factor(scene, options.mesh_factors[0]);
    std::vector<Size> views = view_sizes(options.layout, {options.size.width, rows});
    views.resize(static_cast<std::size_t>(columns_of(options.layout)));
    int left = 0;
    for (const Size &size : views) {
        const double aspect = aspect_of(size);
        std::vector<Arrow> arrows;
        if (const auto at = options.marks.pixel; at && options.marks.vectors) {
            const Technique truth = truth_of_side(options, false);
            const auto place = [](double share, int length) {
                return std::min(static_cast<int>(share * length), length - 1);
            };
            const auto probe =
                painters.probe(left_scene, truth, size, place(at->x, size.width), place(at->y, size.height));
            if (probe) {
                arrows = arrows_of(scene, truth.model, *probe, aspect);
            }
        }
        ByteImage view = cut(picture, left, top, size);
        draw_marks(view, words_of_labels(options.language), options.marks, arrows, text,
                   options.drawn_over.lights ? light_marks(scene, aspect) : std::vector<LightMark>{});
        paste(picture, view, left, top);
        left += size.width;
    }
}

} // namespace

std::pair<std::string, std::string> names_of(const Words &words, DifferenceOf of) {
    return {of == DifferenceOf::b_truth ? "B" : "A", of == DifferenceOf::a_b ? "B" : words.text("truth")};
}

std::string difference_text(const Words &words, double largest) {
    return !std::isfinite(largest) ? words.text("difference.not_finite")
           : largest == 0          ? words.text("difference.none")
                                   : words.format("difference.largest", largest);
}

std::string mesh_factor_note(const Words &words, double factor) {
    return factor == 1 ? "" : words.format("label.mesh", mesh_factor_text(factor));
}

std::string truth_label(const Words &words, const Technique &technique, double mesh_factor) {
    return words.format("label.truth", title_of(words, model_key, model_key.get(technique))) +
           mesh_factor_note(words, mesh_factor);
}

std::string_view to_string(DifferenceOf of) { return difference_names[static_cast<std::size_t>(of)]; }

DifferenceOf parse_difference_of(std::string_view text) {
    const auto found = std::ranges::find(difference_names, text);
    if (found == difference_names.end()) {
        throw InputError("expected a-b, a-reference or b-reference, got '{}'", text);
    }
    return static_cast<DifferenceOf>(found - difference_names.begin());
}

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

Technique truth_of(const Technique &technique, const Technique &other) {
    return {.frequency = Frequency::per_pixel, .model = technique.model == Model::own ? other.model : technique.model};
}

Image draw_picture(const Scene &scene, const PictureOptions &options, const Painters &painters) {
    return compose(options.layout, draw_views(scene, options, options.size, painters), options.divider);
}

Size room_for_views(const PictureOptions &options) {
    const Strips strips = strips_of(options);
    return {options.size.width, options.size.height - strips.above - strips.below};
}

Size size_around(PictureOptions options, Size room) {
    options.size = room;
    const Strips strips = wished_strips(options);
    options.size.height += strips.above + strips.below;
    return room_for_views(options) == room ? options.size : room;
}

ByteImage show_picture(const Scene &scene, const PictureOptions &options, const Painters &painters) {
    const Strips strips = strips_of(options);
    const int rows = options.size.height - strips.above - strips.below;
    const std::vector<Image> views = draw_views(scene, options, {options.size.width, rows}, painters);
    const bool difference = options.layout == Layout::difference;
    const double text = strips.text > 0 ? strips.text : std::clamp(rows / 30.0, 8.0, 64.0);
    ByteImage shown = black_picture(options.size);
    ShownViews of_views;
    if (difference) {
        paste(shown, difference_picture(views[0], views[1], options.gain), 0, strips.above);
    } else {
        of_views = show_views(views, scene, options, painters);
        paste_views(shown, of_views.pictures, options, strips.above);
    }
    mark_views(shown, scene, options, painters, strips.above, rows, text);
    draw_legends(shown, of_views.masked, options, strips.above + rows, text);
    if (!difference && (options.layout == Layout::wipe || options.labels)) {
        for (const int split : splits_of(options)) {
            draw_divider(shown, split, strips.above, rows);
        }
    }
    draw_labels(shown, strips);
    if (strips.below > 0) {
        const Words words = words_of_labels(options.language);
        const auto [first, second] = names_of(words, options.difference_of);
        draw_scale(shown, strips,
                   {.what = fmt::format("{} - {}", first, second),
                    .result = difference_text(words, largest_difference(views[0], views[1])),
                    .low = words.format("difference.brighter", second),
                    .high = words.format("difference.brighter", first),
                    .gain = options.gain});
    }
    return shown;
}

} // namespace sandbox
