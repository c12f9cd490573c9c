#include "ui/jobs/motion_job.h"

#include "capture/frame_names.h"
#include "image/image_file.h"
#include "measure/stability/textbook.h"
#include "reference/reference.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

namespace sandbox {

namespace {

constexpr int small_height = 120; // pixels; the truth then takes about 30 ms a moment

Size small_size(Size view) {
    const int height = std::min(small_height, view.height);
    return {std::max(1, view.width * height / std::max(view.height, 1)), height};
}

double largest_change(const Frame &before, const Frame &now) {
    double largest = 0;
    for (std::size_t i = 0; i < now.color.pixels.size(); ++i) {
        if (before.object_ids[i] == now.object_ids[i]) {
            for (int channel = 0; channel < 3; ++channel) {
                const auto change =
                    static_cast<double>(std::abs(now.color.pixels[i][channel] - before.color.pixels[i][channel]));
                largest = std::isfinite(change) ? std::max(largest, change) : largest;
            }
        }
    }
    return largest;
}

/// A, B and the truth of A's model.
std::array<Frame, 3> draw_moment(const SidesShown &shown, Size size, Renderer &renderer, const Progress &progress) {
    std::array<Frame, 3> frames;
    const Scene left = shown.scene_of(false), right = shown.scene_of(true);
    const auto resources = renderer.resources().load(left); // held while B's meshes are loaded
    frames[0] = shown.textbook_left ? textbook_picture(left, resources, shown.left, size)
                                    : renderer.render(left, shown.left, size, true);
    frames[1] = renderer.render(right, shown.right, size, true);
    frames[2] = to_frame(render_reference(left, resources, shown.truth_of_side(false), size, Surface::mesh, progress));
    return frames;
}

} // namespace

ChangesJob::ChangesJob(const DrawingSupplies &supplies, const SidesShown &shown, const Motion &motion)
    : shared_(std::make_shared<Shared>()) {
    shared_->changes = {shown, motion, small_size(shown.size), {}};
    const auto work = [shared = shared_, shown, motion](DrawingTurn &turn, JobReporter &reporter) {
        const int moments = moments_of(motion);
        const Size size = small_size(shown.size);
        std::array<Frame, 3> before;
        SidesShown now = shown;
        for (int moment = 0; moment < moments; ++moment) {
            turn.let_others_draw();
            now.scene = moved(shown.scene, motion, moment);
            std::array<Frame, 3> frames =
                draw_moment(now, size, turn.renderer(), [&](double) { return !reporter.cancelled(); });
            if (moment > 0) {
                const std::lock_guard lock(shared->mutex);
                for (std::size_t i = 0; i < frames.size(); ++i) {
                    shared->changes.curves[i].push_back(largest_change(before[i], frames[i]));
                }
            }
            before = std::move(frames);
            if (!reporter.report((moment + 1.0) / moments)) {
                return false;
            }
        }
        return true;
    };
    job_ = std::make_unique<DrawingJob<bool>>(supplies, work);
}

Changes ChangesJob::changes() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->changes;
}

std::unique_ptr<SequenceJob> start_sequence(const DrawingSupplies &supplies, const Scene &scene, const Motion &motion,
                                            const PictureOptions &options, const std::filesystem::path &folder,
                                            const std::function<Painters(Renderer &)> &painters_of) {
    const auto draw = [=, by = supplies.by](DrawingTurn &turn, JobReporter &reporter) {
        const Painters painters = painters_of(turn.renderer());
        const std::string pattern = "frame_%04d.png";
        const int moments = moments_of(motion);
        write_file(sidecar_path(folder / pattern), motion_sidecar(sidecar_text(scene, options, by, folder), motion));
        for (int moment = 0; moment < moments; ++moment) {
            turn.let_others_draw();
            const std::string name = frame_name(pattern, moment);
            reporter.say(name);
            const Scene now = moved(scene, motion, moment);
            write_file(folder / name, encode_png(show_picture(now, options, painters)));
            if (!reporter.report((moment + 1.0) / moments)) {
                break;
            }
        }
        return folder;
    };
    return std::make_unique<SequenceJob>(supplies, draw);
}

std::unique_ptr<SequenceJob> start_sweep(const DrawingSupplies &supplies, const Scene &scene, const Grid &grid,
                                         const PictureOptions &options, const std::filesystem::path &path,
                                         const std::function<Painters(Renderer &)> &painters_of) {
    const auto draw = [=, by = supplies.by](DrawingTurn &turn, JobReporter &reporter) {
        reporter.say(path.filename().string());
        const auto after_cell = [&](double share) {
            turn.let_others_draw();
            return reporter.report(share);
        };
        const ByteImage picture =
            draw_grid(scene, grid, options, painters_of(turn.renderer()), "the sweep", after_cell);
        const PictureOptions cell = cell_options(options, grid.techniques.front());
        const std::filesystem::path in = path.parent_path();
        write_files(std::vector<OutputFile>{
            {path, encode_png(picture)}, {sidecar_path(path), grid_text(sidecar_text(scene, cell, by, in), grid, in)}});
        return path;
    };
    return std::make_unique<SequenceJob>(supplies, draw);
}

} // namespace sandbox
