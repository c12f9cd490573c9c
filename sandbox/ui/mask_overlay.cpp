#include "ui/mask_overlay.h"

#include "image/error.h"
#include "ui/jobs/drawing_job.h"

#include <algorithm>
#include <imgui.h>
#include <utility>

namespace sandbox {

void MaskOverlay::start(Side &side, const Key &key, ViewPainter &painter) {
    side.job.reset();
    side.texture.reset();
    side.key = key;
    side.found = std::make_shared<Found>();
    try {
        Frame drawn = painter.renderer().render(key.scene, key.technique, key.size, true);
        const auto work = [key, found = side.found, drawn = std::move(drawn),
                           resources = painter.renderer().resources().load(key.scene)](JobReporter &reporter) {
            const Technique right{.frequency = Frequency::per_pixel, .model = key.technique.model};
            const ReferenceFrame truth = render_reference(key.scene, resources, right, key.size, Surface::mesh,
                                                          [&](double share) { return reporter.report(share); });
            found->metrics = compare(drawn, truth, Flip::without);
            found->picture =
                mask_picture(to_display(drawn.color, key.display, key.exposure), pixel_uses(drawn.object_ids, truth));
        };
        side.job = std::make_unique<BackgroundJob>(work, wake_window);
    } catch (const InputError &) {
        side.job.reset(); // the view itself shows why it cannot be drawn
    }
}

void MaskOverlay::finish(Side &side) {
    if (side.job && side.job->state() != JobState::running) {
        if (side.job->state() == JobState::done) {
            side.texture.emplace(side.found->picture);
        }
        side.job.reset();
    }
}

void MaskOverlay::update(const Session &session, ViewPainter &painter) {
    for (const bool right : {false, true}) {
        Side &side = sides_[right ? 1 : 0];
        const Size size = painter.view(right).size;
        if (!session.view.masks || size.width == 0) {
            side = {};
            painter.show_masks(right, {});
            continue;
        }
        const Document &document = session.document;
        const Key key{scene_in_view(document, size), session.technique(right), size, document.display,
                      document.exposure};
        if (side.key != key && !ImGui::IsAnyItemActive()) {
            start(side, key, painter);
        }
        finish(side);
        const bool current = side.key == key && side.texture;
        painter.show_masks(right, {current ? side.texture->texture() : 0, side.job ? side.job->progress().share : 1,
                                   current ? std::optional(side.found->metrics) : std::nullopt});
    }
}

News MaskOverlay::take_news() {
    News news = News::none;
    for (Side &side : sides_) {
        news = side.job ? std::max(news, side.job->take_news()) : news;
    }
    return news;
}

} // namespace sandbox
