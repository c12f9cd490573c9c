#include "teach/pictures.h"

#include "measure/stability/textbook.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace sandbox {
namespace {

using Kind = PictureSource::Kind;

constexpr std::size_t most_kept = 24; ///< pictures: a motion's moments come and go

/// Of a picture that is drawn or computed, as drawn.
Frame frame_of(const Picture &picture) {
    const auto *drawn = std::get_if<Frame>(&picture);
    return drawn != nullptr ? *drawn : to_frame(std::get<ReferenceFrame>(picture));
}

struct Part {
    int left = 0, top = 0;
    Size size;
};
Part part_of(Size size, const glm::dvec4 &region) {
    const auto pixel = [](double share, int length) { return static_cast<int>(std::lround(share * length)); };
    const int left = std::min(pixel(region.x, size.width), size.width - 1);
    const int top = std::min(pixel(region.y, size.height), size.height - 1);
    return {
        left, top, {std::max(pixel(region.z, size.width) - left, 1), std::max(pixel(region.w, size.height) - top, 1)}};
}

template <class Value> void cut_out(std::vector<Value> &values, Size whole, const Part &part) {
    std::vector<Value> kept;
    for (int y = 0; y < part.size.height && !values.empty(); ++y) {
        const auto begin = values.begin() + static_cast<std::ptrdiff_t>(part.top + y) * whole.width + part.left;
        kept.insert(kept.end(), begin, begin + part.size.width);
    }
    values = std::move(kept);
}

} // namespace

Technique technique_of(const PictureSource &source, const LessonStep &step, const Technique &other) {
    switch (source.kind) {
    case Kind::left:
        return *step.left;
    case Kind::right:
        return *step.right;
    case Kind::technique:
        return source.technique;
    case Kind::reference:
    case Kind::analytic: {
        Technique truth;
        truth.model = other.model;
        truth.normalisation = other.normalisation;
        return truth;
    }
    case Kind::twin:
    case Kind::textbook:
    case Kind::color:
        break;
    }
    return other;
}

double mesh_factor_of(const PictureSource &source, const LessonStep &step, const PictureSource &other) {
    const bool named = source.kind == Kind::left || source.kind == Kind::right || source.kind == Kind::technique;
    return (named ? source : other).kind == Kind::right ? step.mesh_factors.y : step.mesh_factors.x;
}

PictureShelf::Hand PictureShelf::hand_of(Kind kind) {
    switch (kind) {
    case Kind::reference:
    case Kind::twin:
        return Hand::reference;
    case Kind::analytic:
        return Hand::analytic;
    case Kind::textbook:
        return Hand::textbook;
    case Kind::left:
    case Kind::right:
    case Kind::technique:
    case Kind::color:
        break;
    }
    return Hand::renderer;
}

Picture PictureShelf::draw(Hand hand, const Technique &technique, const Scene &scene, Size size) const {
    switch (hand) {
    case Hand::reference:
        return render_reference(scene, draw_.load(scene), technique, size);
    case Hand::analytic:
        return render_reference(scene, draw_.load(scene), technique, size, Surface::analytic);
    case Hand::textbook:
        return textbook_picture(scene, draw_.load(scene), technique, size);
    case Hand::renderer:
        break;
    }
    return draw_.picture(scene, technique, size);
}

Picture PictureShelf::picture(const PictureSource &source, const Technique &technique, const Scene &scene, Size size) {
    const Hand hand = hand_of(source.kind);
    auto found = std::ranges::find_if(drawn_, [&](const Entry &entry) {
        return entry.hand == hand && entry.technique == technique && entry.size == size && entry.scene == scene;
    });
    if (found == drawn_.end()) {
        if (drawn_.size() == most_kept) {
            drawn_.erase(drawn_.begin());
        }
        drawn_.push_back({hand, technique, size, scene, draw(hand, technique, scene, size)});
        found = drawn_.end() - 1;
    }
    Picture picture = found->picture;
    if (source.kind == Kind::color) {
        std::ranges::fill(std::get<Frame>(picture).color.pixels, glm::vec4(glm::vec3(source.color), 1));
    }
    return picture;
}

Picture cropped(Picture picture, const std::optional<glm::dvec4> &region) {
    if (!region) {
        return picture;
    }
    if (auto *drawn = std::get_if<Frame>(&picture)) {
        const Size whole = drawn->color.size;
        const Part part = part_of(whole, *region);
        cut_out(drawn->color.pixels, whole, part);
        cut_out(drawn->object_ids, whole, part);
        drawn->color.size = part.size;
        return picture;
    }
    auto &truth = std::get<ReferenceFrame>(picture);
    const Part part = part_of(truth.size, *region);
    cut_out(truth.color, truth.size, part);
    cut_out(truth.object_ids, truth.size, part);
    for (auto *mask : {&truth.edge, &truth.rival, &truth.jump, &truth.rounding}) {
        cut_out(*mask, truth.size, part);
    }
    truth.size = part.size;
    return picture;
}

Metrics compare_pictures(const Picture &left, const Picture &right, Flip flip) {
    const auto *drawn = std::get_if<Frame>(&left);
    const auto *truth = std::get_if<ReferenceFrame>(&right);
    if (drawn == nullptr) {
        return truth != nullptr ? compare(std::get<ReferenceFrame>(left), *truth, flip)
                                : compare_pictures(right, left, flip); // every metric is symmetric
    }
    return truth != nullptr ? compare(*drawn, *truth, flip) : compare(*drawn, std::get<Frame>(right), flip);
}

std::size_t differing_bits(const Picture &left, const Picture &right) {
    const std::vector<glm::vec4> a = frame_of(left).color.pixels, b = frame_of(right).color.pixels;
    std::size_t count = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        count += std::memcmp(&a[i], &b[i], sizeof a[i]) != 0 ? 1 : 0;
    }
    return count;
}

double brightest(const Picture &picture) {
    const Frame frame = frame_of(picture);
    double most = 0;
    for (std::size_t i = 0; i < frame.object_ids.size(); ++i) {
        for (int channel = 0; channel < 3 && frame.object_ids[i] != 0; ++channel) {
            const double value = frame.color.pixels[i][channel];
            most = std::isfinite(value) ? std::max(most, value) : std::numeric_limits<double>::infinity();
        }
    }
    return most;
}

} // namespace sandbox
