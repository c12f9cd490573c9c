#pragma once

#include "measure/metrics/quantity.h"
#include "reference/reference.h"

#include <string>

namespace sandbox {

/// What the frequency `auto` promised for a picture, and what it kept.
struct CertificateFigures {
    double tolerance = 0;
    double bound = 0;
    double error = 0;
    double share = 0;
    std::size_t triangles = 0, facing = 0;
    double choosing = 0;
    std::string nothing_proved; ///< why all is per pixel, where the technique decides that
    bool operator==(const CertificateFigures &) const = default;
};
inline constexpr Quantity<CertificateFigures> certificate_quantities[]{
    {"tolerance", "tolerance", "linear colour", "largest difference from per-pixel that was allowed",
     &CertificateFigures::tolerance},
    {"bound", "proved", "linear colour", "largest difference from per-pixel that the proof leaves possible",
     &CertificateFigures::bound},
    {"true_error", "true error", "linear colour", "largest difference from per-pixel on the same mesh, both in double",
     &CertificateFigures::error},
    {"per_vertex_share", "share of area", "", "share of the area seen, hidden or not, that is lit per vertex",
     &CertificateFigures::share},
    {"per_vertex_triangles", "triangles", "", "triangles that are lit per vertex", &CertificateFigures::triangles},
    {"facing_triangles", "facing", "", "triangles whose front may be seen", &CertificateFigures::facing},
    {"choosing", "choosing, ms", "ms", "time to choose and to prove", &CertificateFigures::choosing},
};

/// Of `technique`, whose frequency is `auto`; `drawn` and `per_pixel` are its picture and that of
/// part_of_auto(technique, Frequency::per_pixel), both in double.
CertificateFigures certificate_figures(const Scene &scene, const std::vector<ObjectResources> &resources,
                                       const Technique &technique, const ReferenceFrame &drawn,
                                       const ReferenceFrame &per_pixel);

} // namespace sandbox
