#include "ui/side_finder.h"

#include "capture/samples.h"
#include "image/error.h"
#include "measure/stability/textbook.h"
#include "ui/jobs/side_findings.h"
#include "ui/views/painters.h"

#include <imgui.h>
#include <utility>

namespace sandbox {

namespace {

/// A picture that comes finished. Whatever else fails aside fails again where the window draws it, and is said there.
MadePicture finished_picture(const SlowPicture &picture, Renderer &renderer) {
    try {
        if (!picture.textbook) {
            return {renderer.render(picture.scene, picture.technique, picture.size).color, ""};
        }
        const auto resources = renderer.resources().load(picture.scene);
        return {textbook_picture(picture.scene, resources, picture.technique, picture.size).color, ""};
    } catch (const std::exception &error) {
        return {{}, error.what()};
    }
}

} // namespace

/// False if there can be no second context.
bool SideFinder::start_job(Task task, Work work) {
    task_ = task;
    try {
        job_ = std::make_unique<DrawingJob<bool>>(
            supplies_,
            [work = std::move(work)](DrawingTurn &turn, JobReporter &reporter) {
                work(turn, reporter);
                return true;
            },
            BackgroundRenderer::Broken::last_good_stands_in);
    } catch (const MachineError &) {
        impossible_ = true;
    }
    return !impossible_;
}

void SideFinder::find_errors_of(const SidesShown &shown) {
    judged_ = shown;
    found_.reset();
    start_job(Task::errors, [this, shown](DrawingTurn &turn, JobReporter &reporter) {
        find_errors(shown, turn, reporter, [&](const Findings &findings) {
            {
                const std::lock_guard lock(mutex_);
                found_ = std::make_shared<const Findings>(findings);
            }
            reporter.wake();
        });
    });
}

void SideFinder::smooth(const ViewKeys &keys) {
    smoothed_ = keys;
    smooth_.reset();
    start_job(Task::smoothing, [this, keys](DrawingTurn &turn, JobReporter &reporter) {
        SmoothPictures pictures{keys, {}};
        for (std::size_t side = 0; side < keys.size(); ++side) {
            const ViewKey &key = keys[side];
            const DrawView draw = painters_of(turn.renderer(), key.overlays).draw;
            pictures.means[side] = std::make_shared<const Image>(
                draw_samples(key.scene, key.size, samples_at_rest, [&](const Scene &shifted) {
                    turn.let_others_draw();
                    return reporter.cancelled() ? throw Cancelled() : draw(shifted, key.technique, key.size);
                }));
        }
        const std::lock_guard lock(mutex_);
        smooth_ = std::make_shared<const SmoothPictures>(std::move(pictures));
    });
}

void SideFinder::find_times_of(const SidesShown &shown) {
    timed_ = shown;
    start_job(Task::times, [this, findings = *found_](DrawingTurn &turn, JobReporter &reporter) {
        Findings timed = findings;
        if (find_times(timed, turn, reporter)) {
            const std::lock_guard lock(mutex_);
            found_ = std::make_shared<const Findings>(std::move(timed));
        }
    });
}

void SideFinder::start_making(const SlowPicture &picture) {
    made_ = picture;
    const bool started = start_job(Task::making, [this, picture](DrawingTurn &turn, JobReporter & /*reporter*/) {
        Renderer &renderer = turn.renderer();
        if (picture.finished()) {
            made_picture_ = finished_picture(picture, renderer);
            return;
        }
        if (!picture.unchosen.empty()) {
            made_picture_.choice =
                certificate::choose(picture.scene, picture.unchosen, picture.technique, aspect_of(picture.size));
            return;
        }
        if (picture.shown) { // the driver compiles at the first draw into such a target
            ScreenTarget screen(picture.size);
            renderer.draw_shown(picture.scene, picture.technique, *picture.shown, screen);
            screen.finish_in_turns();
        } else {
            Target target(picture.size);
            renderer.draw(picture.scene, picture.technique, target);
            if (picture.overlays != Overlays{}) {
                renderer.draw_overlays(picture.scene, picture.technique, picture.overlays, target);
            }
            if (picture.difference) {
                DisplayTexture colors(picture.size);
                DisplayPass(renderer.parts()).run_difference(target, target, colors, 1);
                colors.finish_in_turns();
            }
            target.finish_in_turns();
        }
    });
    if (!started) {
        made_.reset();
    }
}

void SideFinder::end_job(ViewPainter &painter) {
    job_.reset();
    if (made_) {
        painter.made_aside(*std::exchange(made_, {}), std::exchange(made_picture_, {}));
    }
}

/// Its end wakes the window; what it was to find is then unknown.
void SideFinder::cancel_job() {
    job_->job().cancel();
    judged_ = task_ == Task::errors ? std::nullopt : judged_;
    smoothed_ = task_ == Task::smoothing ? std::nullopt : smoothed_;
    timed_ = task_ == Task::times ? std::nullopt : timed_;
}

/// Of the lesson's next step, one after the other; nothing once all is made.
std::optional<SlowPicture> SideFinder::ahead(const Session &session, ViewPainter &painter) {
    if (session.document.step == ahead_of_) {
        return std::nullopt;
    }
    for (const bool right : {false, true}) {
        if (auto slow = painter.slow_ahead(session, right)) {
            return slow;
        }
    }
    ahead_of_ = session.document.step;
    return std::nullopt;
}

void SideFinder::update(const Session &session, ViewPainter &painter) {
    if (job_ && job_->job().state() != JobState::running) {
        end_job(painter);
    }
    if (impossible_) {
        painter.wait_for_no_program();
        return;
    }
    if (const SlowPicture *picture = painter.awaited()) {
        if (!job_) {
            start_making(*picture);
        } else if (task_ != Task::making) {
            cancel_job();
        }
        return;
    }
    if (painter.view(false).size.width == 0) {
        return;
    }
    const SidesShown shown = painter.sides_shown(shown_document(session));
    const std::optional<ViewKeys> keys = painter.smooth_wanted(session);
    if (job_) {
        const bool current = task_ == Task::errors      ? judged_ == shown
                             : task_ == Task::smoothing ? smoothed_ == keys
                                                        : timed_ == shown;
        if (!current && task_ != Task::making) {
            cancel_job();
        }
    } else if (!ImGui::IsAnyItemActive() && !session.playback.playing) {
        if (judged_ != shown) {
            find_errors_of(shown);
        } else if (const auto slow = ahead(session, painter)) {
            start_making(*slow);
        } else if (keys && smoothed_ != keys) {
            smooth(*keys);
        } else if (timed_ != shown && found_) {
            find_times_of(shown);
        }
    }
    const std::lock_guard lock(mutex_);
    painter.show_findings(judged_ == shown ? found_ : nullptr);
    painter.show_smooth(smoothed_ == keys ? smooth_ : nullptr);
}

News SideFinder::take_news() { return job_ ? job_->job().take_news() : News::none; }

} // namespace sandbox
