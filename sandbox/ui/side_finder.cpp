#include "ui/side_finder.h"

#include "image/error.h"
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

void SideFinder::start(const SidesShown &shown) {
    started_ = shown;
    found_.reset();
    if (!context_) {
        try {
            context_ = supplies_.context->make_worker();
        } catch (const MachineError &) {
            impossible_ = true;
            return;
        }
    }
    job_ = std::make_unique<BackgroundJob>(
        [this, shown](JobReporter &reporter) {
            const WorkerContext::Current current(*context_);
            if (!renderer_) {
                renderer_ = std::make_unique<Renderer>(supplies_.assets, ShaderParts(supplies_.shaders));
            }
            renderer_->reload_changed_parts();
            find_out(shown, *renderer_, reporter, [&](const Findings &findings) {
                {
                    const std::lock_guard lock(mutex_);
                    found_ = std::make_shared<const Findings>(findings);
                }
                reporter.wake();
            });
        },
        wake_window);
}

void SideFinder::update(const Session &session, ViewPainter &painter) {
    if (painter.view(false).size.width == 0 || impossible_) {
        return;
    }
    wanted_ = painter.sides_shown(shown_document(session));
    if (job_ && job_->state() != JobState::running) {
        job_.reset();
    }
    if (started_ != wanted_) {
        if (job_) {
            job_->cancel(); // its end wakes the window
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
