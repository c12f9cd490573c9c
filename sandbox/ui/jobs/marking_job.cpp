#include "ui/jobs/marking_job.h"

#include "image/error.h"

#include <utility>

namespace sandbox {

/// What is kept from one job to the next. The renderer is the same in all turns.
struct ExerciseMarker::Work {
    explicit Work(std::shared_ptr<const Exercise> asked) : exercise(std::move(asked)) {}

    std::shared_ptr<const Exercise> exercise;
    MarkDraw draw;
    std::unique_ptr<Marker> marker; ///< from the first job on
    DrawingTurn *turn = nullptr;    ///< of the job that runs
    JobReporter *reporter = nullptr;

    /// Before each picture.
    void give_way() const {
        turn->let_others_draw();
        if (reporter->cancelled()) {
            throw Cancelled();
        }
    }
    void begin(DrawingTurn &now, JobReporter &reports) {
        turn = &now;
        reporter = &reports;
        if (marker != nullptr) {
            return;
        }
        draw = marks_drawn_by(now.renderer());
        draw.trusted.picture = [this, picture = draw.trusted.picture](const Scene &scene, const Technique &technique,
                                                                      Size size, bool object_ids) {
            give_way();
            return picture(scene, technique, size, object_ids);
        };
        draw.own = [this, own = draw.own](const Scene &scene, const Technique &technique, Size size, bool object_ids) {
            give_way();
            return own(scene, technique, size, object_ids);
        };
        marker = std::make_unique<Marker>(*exercise, draw);
    }
};

ExerciseMarker::ExerciseMarker(DrawingSupplies supplies, std::shared_ptr<const Exercise> exercise)
    : supplies_(std::move(supplies)), work_(std::make_shared<Work>(std::move(exercise))) {}

void ExerciseMarker::mark(const OwnShader &text) {
    job_.reset(); // stops it, and waits
    marks_ = text;
    failure_.clear();
    job_ =
        std::make_unique<DrawingJob<Mark>>(supplies_, [work = work_, text](DrawingTurn &turn, JobReporter &reporter) {
            work->begin(turn, reporter);
            return work->marker->mark_own(text);
        });
}

News ExerciseMarker::take_news() {
    const News news = job_ ? job_->job().take_news() : News::none;
    if (news != News::result) {
        return news;
    }
    if (job_->job().state() == JobState::failed) {
        failure_ = job_->job().error();
    } else if (auto mark = job_->take_result()) {
        result_ = {marks_, std::move(*mark)};
    }
    job_.reset();
    return news;
}

} // namespace sandbox
