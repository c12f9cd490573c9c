#pragma once

#include "measure/report/report.h"
#include "reference/reference.h"
#include "scene/mesh.h"

#include <memory>
#include <utility>
#include <vector>

namespace sandbox {

/// A report of a ball under a lamp, whose pictures are the reference's and whose times grow with every frame.
inline ReportRun measured_ball(Scene scene, const PlanOptions &options) {
    scene.objects = {{"ball", SphereShape{1, 16, 32}, {}, {}, false}};
    const auto load = [](const Scene &s) {
        return std::vector<ObjectResources>{{std::make_shared<const Mesh>(build_mesh(s.objects[0].mesh)), nullptr}};
    };
    double ms = 0;
    ReportRun run;
    run.measured = measure_work_precision(
        scene, options,
        {load,
         [&](const Scene &s, const Technique &t) { return to_frame(render_reference(s, load(s), t, options.size)); },
         [&](const Scene &, const Technique &) { return ms += 0.125; }});
    run.machine = {"llvmpipe", "3.3", "A processor", 2, "1", "release", "a clock"};
    run.version = "1.2.3";
    run.date = "2031-05-01 12:00";
    return run;
}

} // namespace sandbox
