#include "measure/metrics/certificate_figures.h"

#include "certificate/choice.h"

#include <algorithm>
#include <cmath>

namespace sandbox {

CertificateFigures certificate_figures(const Scene &scene, const std::vector<ObjectResources> &resources,
                                       const Technique &technique, const ReferenceFrame &drawn,
                                       const ReferenceFrame &per_pixel) {
    const certificate::Choice choice = certificate::choose(scene, resources, technique, aspect_of(drawn.size));
    CertificateFigures figures{.tolerance = technique.tolerance,
                               .bound = choice.bound,
                               .share = choice.share(),
                               .choosing = choice.milliseconds,
                               .nothing_proved = choice.nothing_proved};
    for (const certificate::ObjectChoice &object : choice.objects) {
        figures.triangles += object.lit_per_vertex;
        figures.facing += object.facing;
    }
    for (std::size_t i = 0; i < drawn.color.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            figures.error = std::max(figures.error, std::abs(drawn.color[i][c] - per_pixel.color[i][c]));
        }
    }
    return figures;
}

} // namespace sandbox
