#include "ui/side_finder.h"

#include "image/error.h"
#include "measure/stability/textbook.h"
#include "ui/jobs/side_findings.h"

#include <imgui.h>
#include <utility>

namespace sandbox {

SideFinder::~SideFinder() {
    job_.reset();
    if (renderer_) {
        const WorkerContext::Current current(*context_); // the window's own is current no more
        renderer_.reset();
    }
}

/// False if there can be no second context.
bool SideFinder::start_job(Work work) {
    if (!context_) {
        try {
            context_ = supplies_.context->make_worker();
        } catch (const MachineError &) {
            impossible_ = true;
            return false;
        }
    }
    job_ = std::make_unique<BackgroundJob>(
        [this, work = std::move(work)](JobReporter &reporter) {
            const WorkerContext::Current current(*context_);
            if (!renderer_) {
                renderer_ = std::make_unique<Renderer>(supplies_.assets, ShaderParts(supplies_.shaders));
            }
            renderer_->reload_changed_parts();
            work(*renderer_, reporter);
        },
        wake_window);
    return true;
}

void SideFinder::start(const SidesShown &shown) {
    started_ = shown;
    found_.reset();
    start_job([this, shown](Renderer &renderer, JobReporter &reporter) {
        find_out(shown, renderer, reporter, [&](const Findings &findings) {
            {
                const std::lock_guard lock(mutex_);
                found_ = std::make_shared<const Findings>(findings);
            }
            reporter.wake();
        });
    });
}

/// Whatever fails here fails again where the window draws it, and is said there.
void SideFinder::start_making(const SlowPicture &picture) {
    made_ = picture;
    made_image_.reset();
    const bool started = start_job([this, picture](Renderer &renderer, JobReporter & /*reporter*/) {
        if (picture.textbook) {
            const auto resources = renderer.resources().load(picture.scene);
            made_image_ = textbook_picture(picture.scene, resources, picture.technique, picture.size).color;
            return;
        }
        Target target(picture.size);
        renderer.draw(picture.scene, picture.technique, target);
        Renderer::finish();
    });
    if (!started) {
        made_.reset();
    }
}

void SideFinder::update(const Session &session, ViewPainter &painter) {
    if (job_ && job_->state() != JobState::running) {
        job_.reset();
        if (made_) {
            painter.made_aside(*std::exchange(made_, {}), std::exchange(made_image_, {}));
        }
    }
    if (impossible_) {
        painter.wait_for_no_program();
        return;
    }
    if (const SlowPicture *picture = painter.awaited()) {
        if (!job_) {
            start_making(*picture);
        } else if (!made_) {
            job_->cancel(); // its end wakes the window
            started_.reset();
        }
        return;
    }
    if (painter.view(false).size.width == 0) {
        return;
    }
    wanted_ = painter.sides_shown(shown_document(session));
    if (started_ != wanted_) {
        if (job_) {
            job_->cancel();
            started_.reset();
        } else if (!ImGui::IsAnyItemActive() && !session.playback.playing) {
            start(*wanted_);
        }
    }
    if (started_ == wanted_) {
        const std::lock_guard lock(mutex_);
        painter.show_findings(found_);
    }
}

News SideFinder::take_news() { return job_ ? job_->take_news() : News::none; }

} // namespace sandbox
