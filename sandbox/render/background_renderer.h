#pragma once

#include "image/thread.h"
#include "render/context.h"
#include "render/own_process.h"
#include "render/renderer.h"
#include "scene/assets.h"

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>

namespace sandbox {

/// The renderer of all jobs, in a context of its own. Jobs take turns, first come, first served: programs and meshes
/// are kept for the next one, no frame is timed while another is drawn, and drivers that fail when several threads draw
/// (llvmpipe looks through the frames of every context of a screen) never see two.
class BackgroundRenderer {
  public:
    /// Nothing is made yet. `window` must outlive this; both end on its thread.
    BackgroundRenderer(const Context &window, Assets assets, Assets shaders);
    /// The window's context is current afterwards.
    ~BackgroundRenderer();
    BackgroundRenderer(const BackgroundRenderer &) = delete;
    BackgroundRenderer &operator=(const BackgroundRenderer &) = delete;

    /// On the window's thread, before the first turn. Throws MachineError (see Context::make_worker).
    void make_context();

    /// How many wait for a turn.
    [[nodiscard]] std::size_t waiting() const;

    /// What is drawn with where the GLSL parts on disk do not build: what the window shows, or nothing.
    enum class Broken { last_good_stands_in, fails };

    /// While it lives, its thread draws and no other job does.
    class Turn {
      public:
        /// Waits until all turns that were asked for before have ended, or `stop` comes. Throws MachineError if there
        /// can be no renderer.
        Turn(BackgroundRenderer &shared, const std::stop_token &stop, Broken broken = Broken::fails);
        ~Turn();
        Turn(const Turn &) = delete;
        Turn &operator=(const Turn &) = delete;

        /// False if `stop` came first: then it is no turn.
        explicit operator bool() const { return begun_; }
        [[nodiscard]] Renderer &renderer() { return *shared_.renderer_; }
        /// Between two pictures: whoever waits draws first. What is bound may be another's afterwards.
        void let_others_draw();

      private:
        BackgroundRenderer &shared_;
        bool begun_ = false;
        std::optional<WorkerContext::Current> current_;
    };

  private:
    bool wait_for(const Turn &turn, const std::stop_token &stop);
    void end_turn();

    const Context &window_;
    Assets assets_, shaders_;
    OwnProcess own_; ///< draws own shading for the renderer
    std::unique_ptr<WorkerContext> context_;
    std::unique_ptr<Renderer> renderer_; ///< lives in that context
    int begun_ = 0;                      ///< turns that have begun and not ended, those that let others draw too
    mutable std::mutex mutex_;
    std::deque<const Turn *> turns_; ///< guarded by mutex_; the first one draws
    Signal turn_ended_;
};

} // namespace sandbox
