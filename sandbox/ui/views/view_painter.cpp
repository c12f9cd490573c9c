#include "ui/views/view_painter.h"

#include "image/difference.h"
#include "image/error.h"
#include "shading/prepared_object.h"
#include "ui/views/painters.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace sandbox {

namespace {

/// Whatever shades the surfaces: their depth hides what is drawn over a finished picture.
constexpr Frequency plainest = Frequency::flat;

/// A window draws what has just moved, and constants would be stale: baked programs are built aside, once it rests, to
/// be measured. `moving`: what `auto` chooses would be stale, too, and within a level of 8 bits per-pixel looks the
/// same; but not with stripes.
Technique as_drawn(const Technique &technique, bool moving, const Overlays &overlays) {
    const bool looks_the_same = technique.tolerance <= default_tolerance && !overlays.proved;
    Technique drawn = moving && looks_the_same ? part_of_auto(technique, Frequency::per_pixel) : technique;
    drawn.program = drawn.program == Program::baked ? Program::specialised : drawn.program;
    return drawn;
}

} // namespace

ViewPainter::ViewPainter(const Assets &assets, const Assets &shaders)
    : own_(own_server_command(assets, shaders, current_profile())), renderer_(assets, ShaderParts(shaders)),
      display_pass_(renderer_.parts()) {
    renderer_.draw_own_by(drawn_by(own_));
}

/// Nothing where it can be drawn at once, or fails at once.
std::optional<SlowPicture> ViewPainter::slow_picture(const Side &side, const ViewKey &key,
                                                     const std::optional<DisplayMap> &shown, bool moving) {
    SlowPicture slow{.right = &side == &sides_[1],
                     .textbook = key.textbook,
                     .scene = key.scene,
                     .technique = key.technique,
                     .size = key.size,
                     .shown = shown,
                     .overlays = key.overlays};
    if (key.finished()) {
        ViewKey alone = key;
        alone.overlays = {};
        return side.finished && side.finished->asked == alone ? std::nullopt : std::optional(slow);
    }
    if (!waits_ || !side.drawn) {
        return std::nullopt; // the first picture comes as soon as it can
    }
    try {
        if (!moving) {
            slow.unchosen = renderer_.unchosen(key.scene, key.technique, key.size);
        }
        if (!slow.unchosen.empty()) {
            return slow;
        }
        slow.programs = renderer_.missing_programs(key.scene, key.technique, key.size, shown);
    } catch (const std::exception &) {
        return std::nullopt;
    }
    const bool built = std::ranges::all_of(slow.programs, [&](const Features &f) { return built_aside_.contains(f); });
    return built ? std::nullopt : std::optional(slow);
}

std::optional<SlowPicture> ViewPainter::slow_ahead(const Session &session, bool right) {
    const Side &side = sides_[right ? 1 : 0];
    const Document next = next_document(session);
    if ((right ? next.right : next.left).frequency == Frequency::automatic) {
        return std::nullopt; // a choice is dropped with the meshes that it was made of
    }
    const ViewSettings view = next_view(session);
    const Scene scene = with_mesh_factor(scene_in_view(next, side.shown.size), next.mesh_factors[right ? 1 : 0]);
    const Overlays overlays = on_surfaces(view.drawn_over, view.layout);
    const ViewKey key{
        scene, as_drawn(right ? next.right : next.left, false, overlays), side.shown.size, false, overlays, reloads_};
    const DisplayMap display{next.display, next.exposure};
    auto slow = slow_picture(side, key, reads_light(view) ? std::nullopt : std::optional(display), false);
    if (slow) {
        slow->difference = view.layout == Layout::difference;
    }
    return slow;
}

const SlowPicture *ViewPainter::awaited() const {
    for (const Side &side : sides_) {
        if (side.awaited) {
            return &*side.awaited;
        }
    }
    return nullptr;
}

void ViewPainter::made_aside(const SlowPicture &picture, MadePicture made) {
    built_aside_.insert(picture.programs.begin(), picture.programs.end());
    Side &side = sides_[picture.right ? 1 : 0];
    side.awaited.reset();
    if (made.choice) {
        renderer_.take_choice(picture.scene, picture.technique, picture.size, picture.unchosen, *made.choice);
    } else if (!picture.unchosen.empty()) { // or it would be asked for again and again
        wait_for_no_program();
    }
    if (!picture.finished()) {
        return;
    }
    const ViewKey key{picture.scene, picture.technique, picture.size, picture.textbook, {}, reloads_};
    if (made.failure.empty()) {
        side.finished = {key, "", key, std::move(made.image)};
    } else { // the last good one stays
        side.finished = side.finished ? side.finished : std::optional(Side::Finished{key, "", key, {}});
        side.finished->asked = key;
        side.finished->failure = std::move(made.failure);
    }
}

void ViewPainter::draw_light(Side &side, const ViewKey &key, const DisplayMap &display) {
    if (!side.target || side.target->size() != key.size) {
        side.target.reset();
        side.target.emplace(key.size);
        side.display.emplace(key.size);
    }
    if (!key.finished()) {
        renderer_.draw(key.scene, key.technique, *side.target);
    } else {
        if (key.overlays != Overlays{}) {
            renderer_.draw(key.scene, {.frequency = plainest, .model = Model::lambert}, *side.target);
        }
        side.target->write_color(side.finished->image);
    }
    side.plain.reset();
    side.shown.nonfinite = display_side(side, display);
    if (key.overlays != Overlays{}) { // after counting, so that lines do not affect it
        renderer_.draw_overlays(key.scene, key.technique, key.overlays, *side.target);
        side.displayed.reset();
    }
}

/// Pixels that are not finite are counted with the errors, aside.
void ViewPainter::draw_shown(Side &side, const ViewKey &key, const DisplayMap &display) {
    if (!side.screen || side.screen->size() != key.size) {
        side.screen.reset();
        side.screen.emplace(key.size);
    }
    renderer_.draw_shown(key.scene, key.technique, display, *side.screen);
    side.displayed = display;
    side.shown.nonfinite = 0;
    ++changes_;
}

/// Else a picture need not be more than what the screen shows.
bool ViewPainter::reads_light(const ViewSettings &view) const {
    return !waits_ || view.layout == Layout::difference || view.masks ||
           on_surfaces(view.drawn_over, view.layout) != Overlays{} || view.overlay == Overlay::profile;
}

/// Returns the number of non-finite pixels.
unsigned ViewPainter::display_side(Side &side, const DisplayMap &display) {
    side.displayed = display;
    ++changes_;
    return display_pass_.run(*side.target, *side.display, display);
}

bool ViewPainter::paint_side(Side &side, const ViewKey &wanted, const DisplayMap &display, bool light, bool moving) {
    const auto is_drawn = [&](const ViewKey &key) {
        return side.drawn == key && side.light == light && (light || side.displayed == display);
    };
    const auto slow = [&](const ViewKey &key) {
        return slow_picture(side, key, light ? std::nullopt : std::optional(display), moving);
    };
    side.awaited = is_drawn(wanted) ? std::nullopt : slow(wanted);
    std::optional<ViewKey> stand_in; // while triangles are chosen
    if (side.awaited && !side.awaited->unchosen.empty()) {
        stand_in = wanted;
        stand_in->technique = as_drawn(wanted.technique, true, wanted.overlays);
        if (!is_drawn(*stand_in) && slow(*stand_in)) {
            stand_in.reset();
        }
    }
    // The last finished picture is shown while the next one is made, so that it follows what is dragged, and where the
    // next one failed.
    const bool failed = !side.awaited && wanted.finished() && side.finished && !side.finished->failure.empty();
    const bool behind = (side.awaited || failed) && wanted.finished() && side.finished &&
                        !side.finished->image.pixels.empty() && side.drawn && side.drawn->finished();
    if (side.awaited && !behind && !stand_in) {
        return false;
    }
    ViewKey key = behind ? side.finished->of : stand_in.value_or(wanted);
    key.overlays = wanted.overlays;
    const bool redraw = !is_drawn(key);
    if (behind) {
        side.shown.warning = side.finished->failure;
    }
    if (!redraw && side.displayed == display) {
        return false;
    }
    try {
        if (redraw) {
            side.drawn = key;
            side.light = light;
            side.displayed.reset();
            side.shown.error.clear();
            side.resources = renderer_.resources().load(key.scene);
            if (failed && !behind) {
                throw InputError(side.finished->failure);
            }
            light ? draw_light(side, key, display) : draw_shown(side, key, display);
            side.shown.warning = behind ? side.finished->failure : renderer_.shader_error();
        }
        if (side.shown.error.empty()) {
            if (side.displayed != display) {
                display_side(side, display);
            }
            side.shown.texture = light ? side.display->texture() : side.screen->texture();
            side.shown.size = key.size;
        }
    } catch (const std::exception &error) {
        side.shown.error = error.what();
        side.shown.texture = 0;
        side.displayed = display;
        side.resources.clear();
    }
    return redraw;
}

/// Without an image there is none. True if it is another picture than before.
bool ViewPainter::upload(std::unique_ptr<Uploaded> &uploaded, const std::shared_ptr<const Image> &image,
                         const DisplayMap &display) {
    if (!image) {
        return std::exchange(uploaded, nullptr) != nullptr;
    }
    const bool redraw = !uploaded || uploaded->image != image;
    if (!uploaded || uploaded->target.size() != image->size) {
        uploaded = std::make_unique<Uploaded>(image->size);
    }
    if (redraw) {
        uploaded->target.write_color(*image);
        uploaded->image = image;
    }
    if (redraw || uploaded->displayed != display) {
        display_pass_.run(uploaded->target, uploaded->display, display);
        uploaded->displayed = display;
        ++changes_;
    }
    return redraw;
}

std::optional<ViewKeys> ViewPainter::smooth_wanted(const Session &session) const {
    const auto &[left, right] = sides_;
    if (samples_shown(session) == 1 || !left.drawn || !right.drawn || left.shown.texture == 0 ||
        right.shown.texture == 0) {
        return std::nullopt;
    }
    return ViewKeys{*left.drawn, *right.drawn};
}

void ViewPainter::paint_smooth(bool right, const DisplayMap &display) {
    Side &side = sides_[right ? 1 : 0];
    std::unique_ptr<Uploaded> &smoothed = smoothed_[right ? 1 : 0];
    const bool fits = smooth_ && side.shown.texture != 0 && side.drawn == smooth_->of[right ? 1 : 0];
    upload(smoothed, fits ? smooth_->means[right ? 1 : 0] : nullptr, display);
    if (side.shown.texture != 0) {
        side.shown.texture = smoothed     ? smoothed->display.texture()
                             : side.light ? side.display->texture()
                                          : side.screen->texture();
    }
}

void ViewPainter::paint_masks(bool right, bool wanted, const DisplayMap &display) {
    std::unique_ptr<Masks> &masks = masks_[right ? 1 : 0];
    const Side &side = sides_[right ? 1 : 0];
    if (!wanted || !findings_ || findings_->sides[right ? 1 : 0].uses.empty() || !side.has_light() ||
        side.drawn->size != findings_->of.size) {
        masks.reset();
        return;
    }
    if (!masks || masks->findings != findings_ || masks->map != display) {
        const ByteImage shown = to_display(side.target->read_color(), display.curve, display.exposure);
        masks = std::make_unique<Masks>(
            Masks{findings_, display, DisplayTexture(mask_picture(shown, findings_->sides[right ? 1 : 0].uses))});
        ++changes_;
    }
}

Image ViewPainter::row(bool right, int y) {
    Side &side = sides_[right ? 1 : 0];
    if (!side.has_light()) {
        return {};
    }
    if (side.drawn->overlays == Overlays{}) {
        return side.target->read_row(y);
    }
    if (!side.plain) {
        side.plain.emplace(side.drawn->size);
        if (side.drawn->finished()) {
            side.plain->write_color(side.finished->image);
        } else {
            renderer_.draw(side.drawn->scene, side.drawn->technique, *side.plain);
        }
    }
    return side.plain->read_row(y);
}

unsigned ViewPainter::mask_texture(bool right) const {
    const auto &masks = masks_[right ? 1 : 0];
    return masks ? masks->texture.texture() : 0;
}

unsigned ViewPainter::truth_texture(bool right) const {
    const auto &truth = truths_[right ? 1 : 0];
    return truth ? truth->display.texture() : 0;
}

/// One of the two pictures of a difference; null: there is none.
const Target *ViewPainter::target_of(DifferenceOf of, bool second) const {
    if (second && of != DifferenceOf::a_b) {
        const auto &truth = truths_[of == DifferenceOf::b_truth ? 1 : 0];
        return truth ? &truth->target : nullptr;
    }
    const Side &side = sides_[second || of == DifferenceOf::b_truth ? 1 : 0];
    return side.has_light() ? &*side.target : nullptr;
}

void ViewPainter::paint_difference(const ViewSettings &view, bool changed) {
    const Target *first = target_of(view.difference_of, false);
    const Target *second = target_of(view.difference_of, true);
    if (first == nullptr || second == nullptr || first->size() != second->size()) {
        difference_.reset();
        return;
    }
    const Size size = first->size();
    if (difference_ && difference_->size() == size && !changed && view.gain == difference_gain_ &&
        view.difference_of == difference_of_) {
        return;
    }
    if (!difference_ || difference_->size() != size) {
        difference_.reset();
        difference_.emplace(size);
    }
    display_pass_.run_difference(*first, *second, *difference_, static_cast<float>(view.gain));
    ++changes_;
    difference_gain_ = view.gain;
    difference_of_ = view.difference_of;
}

SidesShown ViewPainter::sides_shown(const Document &document) const {
    const Size size = view(false).size;
    return {scene_in_view(document, size), document.left, document.right, document.left_is_textbook(), size, reloads_,
            document.mesh_factors};
}

void ViewPainter::paint(const Session &session, Size each, bool moving) {
    const Document document = shown_document(session);
    const ViewSettings &view = session.view;
    const DisplayMap display{document.display, document.exposure};
    bool changed = view.difference_of != difference_of_;
    const Scene seen = scene_in_view(document, each);
    const Overlays overlays = on_surfaces(view.drawn_over, view.layout);
    for (const bool right : {false, true}) {
        const bool textbook = !right && document.left_is_textbook();
        const double factor = document.mesh_factors[right ? 1 : 0];
        const ViewKey key{with_mesh_factor(seen, factor),
                          as_drawn(session.technique(right), moving, overlays),
                          each,
                          textbook,
                          overlays,
                          reloads_};
        changed |= paint_side(sides_[right ? 1 : 0], key, display, key.finished() || reads_light(view), moving);
    }
    if (samples_shown(session) == 1) {
        smooth_.reset();
    }
    if (findings_ && !(findings_->of == sides_shown(document))) {
        findings_.reset();
    }
    for (const bool right : {false, true}) {
        const bool in_difference = view.layout == Layout::difference &&
                                   view.difference_of == (right ? DifferenceOf::b_truth : DifferenceOf::a_truth);
        const bool truth = findings_ && (in_difference || (!right && view.layout == Layout::three_up));
        changed |= upload(truths_[right ? 1 : 0], truth ? findings_->sides[right ? 1 : 0].truth : nullptr, display);
        paint_smooth(right, display);
        paint_masks(right, view.masks && view.layout != Layout::difference, display);
    }
    measured_ = measured_ && !changed;
    if (view.layout == Layout::difference) {
        paint_difference(view, changed);
    } else {
        difference_.reset();
    }
}

void ViewPainter::measure_difference() {
    if (measured_ || difference_texture() == 0) {
        return;
    }
    measured_ = true;
    largest_difference_ = sandbox::largest_difference(target_of(difference_of_, false)->read_color(),
                                                      target_of(difference_of_, true)->read_color());
}

std::vector<std::size_t> ViewPainter::triangles(bool right) const {
    std::vector<std::size_t> counts;
    for (const ObjectResources &object : sides_[right ? 1 : 0].resources) {
        counts.push_back(object.mesh->triangles.size());
    }
    return counts;
}

std::array<std::vector<ObjectResources>, 2> ViewPainter::resources_of(const SidesShown &shown) {
    Resources &resources = renderer_.resources();
    return {resources.load(shown.scene_of(false)), resources.load(shown.scene_of(true))};
}

bool ViewPainter::same_picture(const Document &document) {
    if (document.left_is_textbook() || document.mesh_factors[0] != document.mesh_factors[1]) {
        return false;
    }
    try {
        const Scene scene = with_mesh_factor(document.scene, document.mesh_factors[0]);
        return sandbox::same_picture(scene, document.left, document.right, renderer_.resources().load(scene));
    } catch (const std::exception &) {
        return false; // the view shows the error
    }
}

bool ViewPainter::reload_changed_shaders() {
    const bool changed = renderer_.reload_changed_parts();
    if (changed) {
        ++reloads_;
        built_aside_.clear();
    }
    return changed;
}

} // namespace sandbox
