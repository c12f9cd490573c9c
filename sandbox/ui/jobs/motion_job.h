#pragma once

#include "capture/grid.h"
#include "capture/picture.h"
#include "scene/motion.h"
#include "ui/jobs/drawing_job.h"
#include "ui/session/findings.h"

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace sandbox {

/// How restless A, B and the truth of A's model are: of every moment of a round, the largest change of any channel
/// since the moment before, over the pixels that show the same object in both. The first moment has none.
struct Changes {
    SidesShown of;
    Motion motion;
    Size size; ///< of the pictures compared
    std::array<std::vector<double>, 3> curves;
};

/// Works the changes out at a small size, moment by moment. All member functions are for the main thread.
class ChangesJob {
  public:
    /// Throws MachineError (see BackgroundRenderer::make_context).
    ChangesJob(const DrawingSupplies &supplies, const SidesShown &shown, const Motion &motion);
    /// As far as it has come.
    [[nodiscard]] Changes changes() const;
    [[nodiscard]] BackgroundJob &job() { return job_->job(); }

  private:
    struct Shared {
        mutable std::mutex mutex;
        Changes changes; ///< guarded by mutex
    };
    std::shared_ptr<Shared> shared_;
    std::unique_ptr<DrawingJob<bool>> job_; ///< last: ends before what it uses
};

/// Draws every moment of a round into `folder`, frame_0000.png and so on, with one sidecar, and returns the folder.
using SequenceJob = DrawingJob<std::filesystem::path>;
std::unique_ptr<SequenceJob> start_sequence(const DrawingSupplies &supplies, const Scene &scene, const Motion &motion,
                                            const PictureOptions &options, const std::filesystem::path &folder,
                                            const std::function<Painters(Renderer &)> &painters_of);

/// Draws a grid into the file `path`, beside it its sidecar, and returns `path`; `options` are those of the views.
std::unique_ptr<SequenceJob> start_sweep(const DrawingSupplies &supplies, const Scene &scene, const Grid &grid,
                                         const PictureOptions &options, const std::filesystem::path &path,
                                         const std::function<Painters(Renderer &)> &painters_of);

} // namespace sandbox
