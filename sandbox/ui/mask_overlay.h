#pragma once

#include "ui/jobs/background_job.h"
#include "ui/views/view_painter.h"

#include <array>
#include <memory>
#include <optional>

namespace sandbox {

/// The masks of both sides, found in the background: which pixels `compare T reference` leaves out, and why.
class MaskOverlay {
  public:
    /// Before a frame: starts what has become out of date, unless the mouse holds something; hands the painter what is
    /// up to date.
    void update(const Session &session, ViewPainter &painter);
    /// News of the jobs since the last call.
    News take_news();
    [[nodiscard]] bool busy() const { return sides_[0].job || sides_[1].job; }

  private:
    struct Key {
        Scene scene;
        Technique technique;
        Size size;
        Display display = Display::linear;
        double exposure = 1;
        bool operator==(const Key &) const = default;
    };
    struct Found {
        ByteImage picture;
        Metrics metrics;
    };
    struct Side {
        std::optional<Key> key; ///< what was asked last, also if that failed
        std::shared_ptr<Found> found;
        std::optional<DisplayTexture> texture;
        std::unique_ptr<BackgroundJob> job; ///< while one runs; before what it writes to is replaced
    };
    static void start(Side &side, const Key &key, ViewPainter &painter);
    static void finish(Side &side);

    std::array<Side, 2> sides_;
};

} // namespace sandbox
