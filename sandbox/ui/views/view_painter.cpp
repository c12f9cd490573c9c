#include "ui/views/view_painter.h"

#include "measure/stability/textbook.h"
#include "shading/prepared_object.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace sandbox {

namespace {

constexpr glm::vec3 wireframe_color{0.9F, 0.9F, 0.9F};

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Infinite if a pixel of either is not finite.
double largest_channel_difference(const Image &left, const Image &right) {
    double largest = 0;
    for (std::size_t i = 0; i < std::min(left.pixels.size(), right.pixels.size()); ++i) {
        const glm::dvec3 apart = glm::abs(glm::dvec3(left.pixels[i]) - glm::dvec3(right.pixels[i]));
        const double most = apart.r + apart.g + apart.b; // NaN if one of them is; std::max would lose it
        largest = std::isfinite(most) ? std::max({largest, apart.r, apart.g, apart.b})
                                      : std::numeric_limits<double>::infinity();
    }
    return largest;
}

} // namespace

void ViewPainter::draw_timed(Side &side, const Key &key) {
    const auto draw = [&] {
        Renderer::finish();
        const auto start = std::chrono::steady_clock::now();
        renderer_.draw(key.scene, key.technique, *side.target);
        Renderer::finish();
        side.shown.milliseconds = milliseconds_since(start);
    };
    const int built_before = renderer_.programs_built();
    draw();
    if (renderer_.programs_built() != built_before) {
        draw(); // the time of a picture, not of its compiler
    }
}

void ViewPainter::draw_textbook(Side &side, const Key &key) {
    if (key.wireframe) {
        renderer_.draw(key.scene, key.technique, *side.target); // the depth that hides lines
    }
    const auto start = std::chrono::steady_clock::now();
    const auto resources = renderer_.resources().load(key.scene);
    side.target->write_color(textbook_picture(key.scene, resources, key.technique, key.size).color);
    side.shown.milliseconds = milliseconds_since(start);
}

/// Returns the number of non-finite pixels.
unsigned ViewPainter::display_side(Side &side, const DisplayKey &display) {
    side.displayed = display;
    return display_pass_.run(*side.target, *side.display, display.display, static_cast<float>(display.exposure));
}

bool ViewPainter::paint_side(Side &side, const Key &key, const DisplayKey &display) {
    const bool redraw = side.drawn != key;
    if (!redraw && side.displayed == display) {
        return false;
    }
    try {
        if (redraw) {
            side.drawn = key;
            side.displayed.reset();
            side.shown.error.clear();
            if (!side.target || side.target->size() != key.size) {
                side.target.reset();
                side.target.emplace(key.size);
                side.display.emplace(key.size);
            }
            key.textbook ? draw_textbook(side, key) : draw_timed(side, key);
            side.shown.warning = renderer_.shader_error();
            side.shown.nonfinite = display_side(side, display);
            if (key.wireframe) { // after timing and counting, so that lines affect neither
                renderer_.draw_wireframe(key.scene, *side.target, wireframe_color);
                side.displayed.reset();
            }
        }
        if (side.shown.error.empty()) {
            if (side.displayed != display) {
                display_side(side, display);
            }
            side.shown.texture = side.display->texture();
            side.shown.size = key.size;
        }
    } catch (const std::exception &error) {
        side.shown.error = error.what();
        side.shown.texture = 0;
        side.displayed = display;
    }
    return redraw;
}

void ViewPainter::paint_difference(double gain, bool changed) {
    const bool both = sides_[0].shown.texture != 0 && sides_[1].shown.texture != 0;
    if (!both || sides_[0].target->size() != sides_[1].target->size()) {
        difference_.reset();
        return;
    }
    const Size size = sides_[0].target->size();
    if (difference_ && difference_->size() == size && !changed && gain == difference_gain_) {
        return;
    }
    if (!difference_ || difference_->size() != size) {
        difference_.reset();
        difference_.emplace(size);
    }
    display_pass_.run_difference(*sides_[0].target, *sides_[1].target, *difference_, static_cast<float>(gain));
    difference_gain_ = gain;
}

void ViewPainter::paint(const Session &session, Size each) {
    const Document &document = session.document;
    const DisplayKey display{document.display, document.exposure};
    bool changed = false;
    const Scene seen = scene_in_view(document, each);
    for (const bool right : {false, true}) {
        const bool textbook = !right && document.left_is_textbook();
        const Key key{seen, session.technique(right), each, textbook, session.view.wireframe, reloads_};
        changed |= paint_side(sides_[right ? 1 : 0], key, display);
    }
    measured_ = measured_ && !changed;
    if (session.view.layout == Layout::difference) {
        paint_difference(session.view.gain, changed);
    } else {
        difference_.reset();
    }
}

void ViewPainter::measure_difference() {
    if (measured_ || difference_texture() == 0) {
        return;
    }
    measured_ = true;
    largest_difference_ = largest_channel_difference(sides_[0].target->read_color(), sides_[1].target->read_color());
}

std::vector<std::size_t> ViewPainter::triangles(const Scene &scene) {
    std::vector<std::size_t> counts;
    try {
        for (const ObjectResources &object : renderer_.resources().load(scene)) {
            counts.push_back(object.mesh->triangles.size());
        }
    } catch (const std::exception &) {
        counts.clear(); // the view shows the error
    }
    return counts;
}

bool ViewPainter::same_picture(const Document &document) {
    try {
        const auto resources = renderer_.resources().load(document.scene);
        return !document.left_is_textbook() &&
               sandbox::same_picture(document.scene, document.left, document.right, resources);
    } catch (const std::exception &) {
        return false; // the view shows the error
    }
}

bool ViewPainter::reload_changed_shaders() {
    const bool changed = renderer_.reload_changed_parts();
    reloads_ += changed ? 1 : 0;
    return changed;
}

} // namespace sandbox
