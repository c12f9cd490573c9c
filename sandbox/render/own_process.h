#pragma once

#include "image/image.h"
#include "render/context.h"
#include "scene/assets.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sandbox {

class ChildProcess;

/// Of processor time, so that a busy machine refuses nothing that a quiet one draws.
struct OwnLimits {
    int seconds_each = 5;           ///< for a picture, building its program included
    std::optional<int> seconds_all; ///< for all pictures of one text together; none: no end
};

/// This executable, serving with the files that `assets` and `shaders` name.
std::vector<std::string> own_server_command(const Assets &assets, const Assets &shaders, Profile profile,
                                            std::string_view backend = "egl");

/// Draws own shading in a process of its own: whatever it does to compiler, driver and memory is done to that process,
/// which has limits. Each text gets a new one, as does whatever follows a failure.
class OwnProcess {
  public:
    /// `command` serves at its standard input, as serve_own_pictures() does.
    explicit OwnProcess(std::vector<std::string> command, OwnLimits limits = {});
    ~OwnProcess();
    OwnProcess(const OwnProcess &) = delete;
    OwnProcess &operator=(const OwnProcess &) = delete;

    /// Of a technique whose model is `own`. Throws InputError "FILE: ..." where the text gives no picture within the
    /// limits, MachineError where no process can be started or it has no OpenGL.
    Frame picture(const Scene &scene, const Technique &technique, Size size, bool object_ids);

  private:
    [[nodiscard]] int allowed() const;
    [[nodiscard]] std::string why_ended(int allowed);

    std::vector<std::string> command_;
    OwnLimits limits_;
    OwnShader text_; ///< the last one drawn
    /// Processor seconds for that text, of processes that have ended and of the one that runs.
    double used_before_ = 0, used_now_ = 0;
    struct Failure {
        Scene scene;
        Technique technique;
        std::string why;
    };
    std::optional<Failure> failure_;        ///< beyond its limits: not tried again
    std::unique_ptr<ChildProcess> process_; ///< null: none runs
};

/// What Renderer::draw_own_by() takes; `own` must outlive it. In a page, which can start no process: nothing, so that the
/// renderer draws.
std::function<Frame(const Scene &, const Technique &, Size, bool)> drawn_by(OwnProcess &own);

} // namespace sandbox
