#pragma once

#include "image/image.h"
#include "scene/resources.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <functional>
#include <string>
#include <vector>

/// Which techniques a report measures on which meshes.
namespace sandbox {

struct PlanOptions {
    Size size{640, 480};
    int first_rings = 8; ///< the coarsest rung of the ladder; every rung has twice the rings of the one before
    int last_rings = 512;
    int warm_ups = 4;              ///< rounds that are drawn and dropped
    int repeats = 21;              ///< rounds that are kept; 0: no times
    std::vector<Technique> only{}; ///< these techniques; none: all, and their variants
    bool operator==(const PlanOptions &) const = default;
};
/// Small picture, short ladder, few repeats: an overview, not a measurement to quote.
PlanOptions quick_plan();

/// The scene on one tessellation.
struct PlannedMesh {
    int rings = 0;      ///< of the ladder; 0: the scene's own meshes, between two rungs
    bool own = false;   ///< these are the scene's own meshes
    bool ladder = true; ///< a rung of the ladder
    std::size_t triangles = 0;
    Scene scene;
};

/// Why a row is measured.
enum class RowGroup { ladder, own_mesh, full_program, baked_program, power, claim, precision };

struct PlannedRow {
    std::size_t mesh = 0; ///< index in the meshes
    Technique technique;
    RowGroup group = RowGroup::ladder;
};

struct OmittedRow {
    std::string technique;
    std::string reason; ///< same_program and a technique
};
inline constexpr std::string_view same_program = "the same program as ";

struct Plan {
    std::vector<PlannedMesh> meshes; ///< from coarse to fine; the own ones, if no rung equals them, first
    std::vector<PlannedRow> rows;    ///< grouped by mesh
    std::vector<OmittedRow> omitted; ///< techniques whose programs equal those of another row
};

/// The scene with every built-in shape rescaled, so that its leading shape (the first sphere's rings, else the first
/// torus's segments, else half of the first cylinder's segments, else the first divisions) gets `rings`. Counts are
/// fixed at `first_rings` and doubled from there, so that every rung halves every triangle. OBJ files keep their mesh.
Scene with_rings(const Scene &scene, int rings, int first_rings);

/// Gives the meshes and textures of a scene.
using Load = std::function<std::vector<ObjectResources>(const Scene &)>;

/// `load` is asked for the meshes: they decide which techniques have equal programs.
Plan plan_report(const Scene &scene, const PlanOptions &options, const Load &load);

} // namespace sandbox
