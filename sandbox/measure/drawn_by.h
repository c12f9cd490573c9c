#pragma once

#include "measure/stability/stability.h"
#include "measure/work_precision/run.h"

#include <chrono>

/// A renderer as the measurements want it. This room cannot name render/'s Renderer and Target, so they are parameters:
/// the commands and the window hand over theirs, tests may hand over fakes. Both must outlive what is returned.
namespace sandbox {

/// Pictures have the size of `target`; frames are timed by `clock` (FrameClock).
template <typename Renderer, typename Target, typename Clock>
DrawRows rows_drawn_by(Renderer &renderer, Target &target, Clock &clock) {
    return {
        [&](const Scene &s) { return renderer.resources().load(s); },
        [&](const Scene &s, const Technique &t) { return renderer.render(s, t, target.size(), true); },
        [&](const Scene &s, const Technique &t) { return clock.milliseconds([&] { renderer.draw(s, t, target); }); }};
}

/// Costs are taken on `target`, which should have stability_timed_size, by the wall clock.
template <typename Renderer, typename Target> StabilityDraw cases_drawn_by(Renderer &renderer, Target &target) {
    const auto timed = [&](const auto &draw) {
        const auto start = std::chrono::steady_clock::now();
        draw();
        renderer.finish();
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    };
    return {[&](const Scene &s) { return renderer.resources().load(s); },
            [&](const Scene &s, const Technique &t, Size size) { return renderer.render(s, t, size, true); },
            [&, timed](const Scene &s, const Technique &t) { return timed([&] { renderer.draw(s, t, target); }); },
            [&, timed](const Scene &s, const Technique &t) {
                return timed([&] { renderer.draw_unguarded(s, t, target); });
            }};
}

} // namespace sandbox
