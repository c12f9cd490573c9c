#include "ui/tabs/bottom_tabs.h"

#include "image/error.h"
#include "ui/jobs/motion_job.h"
#include "ui/session/written_files.h"
#include "ui/tabs/motion_strip.h"
#include "ui/views/painters.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <imgui.h>
#include <string>
#include <vector>

namespace sandbox {

namespace {

/// What moves and how, its playing, and how far the pictures jump from moment to moment.
class MotionTab final : public TabContent {
  public:
    explicit MotionTab(const DrawingSupplies &supplies) : supplies_(supplies) {}
    void draw(Session &session, ViewPainter &painter) override;
    News take_news(Session &session) override;
    [[nodiscard]] bool busy() const override { return changes_job_ != nullptr || sequence_job_ != nullptr; }

  private:
    void find_changes(const Session &session, const ViewPainter &painter);
    void buttons(Session &session, ViewPainter &painter);
    void capture(Session &session, ViewPainter &painter);
    void sweep_controls(Session &session, ViewPainter &painter);
    void capture_sweep(Session &session, ViewPainter &painter);

    DrawingSupplies supplies_;
    std::optional<Changes> changes_;            ///< the last ones, perhaps not whole
    std::unique_ptr<ChangesJob> changes_job_;   ///< while one runs
    std::unique_ptr<SequenceJob> sequence_job_; ///< likewise, of a sequence or a sweep
    double sweep_values_ = 5;
};

std::vector<Motion> offered_motions(const Scene &scene) {
    std::vector<Motion> all{{.mover = Mover::camera}};
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        all.push_back({.mover = Mover::light, .index = i});
    }
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        all.push_back({.mover = Mover::object, .index = i});
    }
    for (const SceneNumber &number : numbers_of(scene)) {
        all.push_back({.mover = Mover::number, .path = number.path});
    }
    return all;
}

std::vector<Label> motion_labels(const Session &session, const std::vector<Motion> &motions) {
    std::vector<Label> labels;
    for (const Motion &motion : motions) {
        const std::string name = motion_words(motion);
        labels.push_back(motion.mover == Mover::number   ? Label(name)
                         : motion.mover == Mover::camera ? session.label("motion.camera")
                         : motion.mover == Mover::light  ? session.label("motion.light", motion.index + 1)
                                                         : session.label("motion.object", motion.index + 1));
    }
    return labels;
}

void what_moves(Session &session) {
    const Motion &now = session.playback.motion;
    const std::vector<Motion> offered = offered_motions(session.document.scene);
    const std::vector<Label> names = motion_labels(session, offered);
    const auto same = [&](const Motion &m) {
        return m.mover == now.mover && (m.mover == Mover::number ? m.path == now.path : m.index == now.index);
    };
    auto chosen = static_cast<std::size_t>(std::ranges::find_if(offered, same) - offered.begin());
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 17);
    if (combo(session, "what", names, chosen, session.text("motion.what.help"))) {
        choose_motion(session, offered[chosen]);
    }
}

void course_controls(Session &session) {
    Motion &motion = session.playback.motion;
    const bool degrees = motion.mover != Mover::number;
    Range range = rotation;
    range.slider = {-360, 360, "%.4g"};
    for (const SceneNumber &number : numbers_of(session.document.scene)) {
        range = !degrees && number.path == motion.path ? number.range : range;
    }
    const auto field = [&](const Label &name, double &value, const Range &of, const std::string &hint, double reset) {
        const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
        same_line_if_fits(ImGui::CalcTextSize(name.shown.c_str()).x + gap + ImGui::GetFontSize() * 6);
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(name.shown.c_str());
        ImGui::SameLine(0, gap);
        ImGui::SetNextItemWidth(ImGui::GetFontSize() * 6);
        slider(session, {name, of, hint}, value, reset);
    };
    field(session.label("motion.from"), motion.from, range,
          session.text(degrees ? "motion.from_degrees.help" : "motion.from.help"), 0);
    field(session.label("motion.to"), motion.to, range,
          session.text(degrees ? "motion.to_degrees.help" : "motion.to.help"), degrees ? 360 : motion.to);
    field(session.label("motion.seconds"), motion.seconds,
          {.low = 0.1, .high = longest_motion, .slider = {1, 30, "%.3g"}}, session.text("motion.seconds.help"), 8);
    for (const auto &[course, key] :
         {std::pair(Course::turn, "motion.turn"), std::pair(Course::to_and_fro, "motion.to_and_fro")}) {
        const Label name = session.label(key);
        same_line_if_fits(button_width(name.shown));
        if (toggle_button(session, name, motion.course == course, session.text(std::string(key) + ".help"))) {
            motion.course = course;
        }
    }
}

void MotionTab::capture(Session &session, ViewPainter &painter) {
    attempt(session, session.text("message.not_captured"), [&] {
        const Size each = painter.view(false).size;
        PictureOptions options = picture_options(session, each);
        options.samples = 1; // as it plays
        const auto folder =
            std::filesystem::absolute(new_folder(capture_folder(), session.document.opened->name + "-motion"));
        sequence_job_ =
            start_sequence(supplies_, scene_in_view(session.document, each), session.playback.motion, options, folder,
                           [overlays = on_surfaces(options.drawn_over, options.layout)](Renderer &renderer) {
                               return painters_of(renderer, overlays);
                           });
    });
}

/// In cells of the views' shape, together no wider than `widest`.
void MotionTab::capture_sweep(Session &session, ViewPainter &painter) {
    attempt(session, session.text("message.not_captured"), [&] {
        constexpr int widest = 8192;
        const Document &document = session.document;
        if (document.left_is_textbook()) {
            throw InputError("A is the textbook's picture, and a sweep is of techniques");
        }
        Grid grid{{document.left},
                  sweep_of(session.playback.motion, document.scene, static_cast<int>(std::lround(sweep_values_)))};
        if (document.left != document.right || document.mesh_factors[0] != document.mesh_factors[1]) {
            grid.techniques.push_back(document.right);
        }
        const Size each = painter.view(false).size;
        PictureOptions options = picture_options(session, each);
        const int width = std::min(each.width, widest / static_cast<int>(grid.sweep.values.size()));
        options.size = {width, std::max(1, each.height * width / std::max(each.width, 1))};
        const auto path = std::filesystem::absolute(free_name(capture_folder(), document.opened->name + "-sweep"));
        sequence_job_ = start_sweep(supplies_, scene_in_view(document, each), grid, options, path,
                                    [overlays = on_surfaces(options.drawn_over, Layout::single)](Renderer &renderer) {
                                        return painters_of(renderer, overlays);
                                    });
    });
}

/// A number alone can be swept.
void MotionTab::sweep_controls(Session &session, ViewPainter &painter) {
    const float field = ImGui::GetFontSize() * 3, gap = ImGui::GetStyle().ItemInnerSpacing.x;
    same_line_if_fits(button_width(session.text("motion.sweep")) + field + 2 * gap +
                      ImGui::CalcTextSize(session.text("motion.values").c_str()).x);
    ImGui::BeginDisabled(session.playback.motion.mover != Mover::number);
    if (button(session, session.label("motion.sweep"), session.text("motion.sweep.help"))) {
        capture_sweep(session, painter);
    }
    ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(field);
    slider(session, row_of(session, "motion.values", {.low = 2, .high = 16, .slider = {2, 16, "%.0f"}}), sweep_values_,
           5);
    ImGui::SameLine(0, gap);
    ImGui::TextUnformatted(session.text("motion.values").c_str());
    ImGui::EndDisabled();
}

void MotionTab::buttons(Session &session, ViewPainter &painter) {
    const Playback &play = session.playback;
    if (toggle_button(session, session.label(play.playing ? "motion.pause" : "motion.play"), play.playing,
                      session.text("motion.play.help"))) {
        play_or_pause(session);
    }
    ImGui::SameLine(0, 2);
    if (button(session, "<", session.text("motion.back.help"))) {
        step_motion(session, -1);
    }
    ImGui::SameLine(0, 2);
    if (button(session, ">", session.text("motion.on.help"))) {
        step_motion(session, 1);
    }
    ImGui::SameLine(0, 2);
    if (button(session, session.label("motion.stop"), session.text("motion.stop.help"))) {
        stop_motion(session);
    }
    ImGui::SameLine(0, 2);
    ImGui::BeginDisabled(!play.shown);
    if (button(session, session.label("motion.keep"), session.text("motion.keep.help"))) {
        keep_moment(session);
    }
    ImGui::EndDisabled();
    same_line_if_fits(button_width(session.text("motion.sequence")));
    if (button(session, session.label("motion.sequence"), session.text("motion.sequence.help"))) {
        capture(session, painter);
    }
    sweep_controls(session, painter);
    const std::string where = !play.shown ? session.text("motion.at_rest")
                                          : session.text("motion.moment", play.moment, moments_of(play.motion));
    same_line_if_fits(ImGui::CalcTextSize(where.c_str()).x);
    ImGui::TextColored(quiet_text(), "%s", where.c_str());
    describe_item(session, "moment", "", where);
}

void MotionTab::find_changes(const Session &session, const ViewPainter &painter) {
    const SidesShown wanted = painter.sides_shown(session.document);
    if (wanted.size.width == 0 || (changes_ && changes_->of == wanted && changes_->motion == session.playback.motion)) {
        return;
    }
    if (changes_job_) {
        changes_job_->job().cancel(); // its end wakes the window
    } else if (!ImGui::IsAnyItemActive()) {
        try {
            changes_job_ = std::make_unique<ChangesJob>(supplies_, wanted, session.playback.motion);
            changes_ = changes_job_->changes();
        } catch (const std::exception &) {
            changes_.reset(); // no second OpenGL context: there is no strip
        }
    }
}

News MotionTab::take_news(Session &session) {
    News news = changes_job_ ? changes_job_->job().take_news() : News::none;
    if (news != News::none) {
        changes_ = changes_job_->changes();
        if (news == News::result) {
            changes_job_.reset();
        }
    }
    const News sequence = sequence_job_ ? sequence_job_->job().take_news() : News::none;
    if (sequence == News::result) {
        if (sequence_job_->job().state() == JobState::failed) {
            session.message = {session.text("message.not_captured") + sequence_job_->job().error(), true};
        } else if (const auto path = sequence_job_->take_result()) {
            session.message = {session.text("message.captured", path->string()), false};
        } else {
            session.message = {session.text("message.capture_cancelled"), false};
        }
        sequence_job_.reset();
    }
    return std::max(news, sequence);
}

void MotionTab::draw(Session &session, ViewPainter &painter) {
    what_moves(session);
    course_controls(session);
    if (sequence_job_) {
        job_progress_row(session, sequence_job_->job());
    } else {
        buttons(session, painter);
    }
    find_changes(session, painter);
    if (changes_) {
        motion_strip(session, *changes_);
    }
}

} // namespace

std::unique_ptr<TabContent> motion_tab(const DrawingSupplies &supplies) {
    return std::make_unique<MotionTab>(supplies);
}

} // namespace sandbox
