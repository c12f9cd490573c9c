#include "measure/work_precision/plan.h"

#include "scene/scene_format.h"
#include "shading/prepared_object.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace sandbox {
namespace {

/// The count by which a shape leads the ladder, and its rank among the shapes; nothing for a mesh from a file, which
/// no ladder can refine.
struct Leading {
    int rank;
    double rings;
};
std::optional<Leading> leading(const SphereShape &shape) { return Leading{0, static_cast<double>(shape.rings)}; }
std::optional<Leading> leading(const TorusShape &shape) { return Leading{1, static_cast<double>(shape.segments)}; }
std::optional<Leading> leading(const CylinderShape &shape) { return Leading{2, shape.segments / 2.0}; }
std::optional<Leading> leading(const BoxShape &shape) { return Leading{3, static_cast<double>(shape.divisions)}; }
std::optional<Leading> leading(const PlaneShape &shape) { return Leading{4, static_cast<double>(shape.divisions)}; }
std::optional<Leading> leading(const ObjShape &) { return std::nullopt; }

std::optional<double> leading_rings(const Scene &scene) {
    std::optional<Leading> best;
    for (const Object &object : scene.objects) {
        const auto lead = std::visit([](const auto &shape) { return leading(shape); }, object.mesh);
        if (!lead) {
            return std::nullopt;
        }
        if (!best || lead->rank < best->rank) {
            best = lead;
        }
    }
    return best ? std::optional(best->rings) : std::nullopt;
}

/// Scales counts to the first rung, then doubles them.
struct Rescale {
    double to_first;
    int doublings;

    /// Every count of the shape, within what a scene file may say.
    template <class S> void operator()(S &shape) const {
        for_each_field<S>([&](const auto &field) {
            auto &value = shape.*field.member;
            if constexpr (std::is_same_v<decltype(value), int &>) {
                const int first =
                    std::max(static_cast<int>(field.range.low), static_cast<int>(std::lround(value * to_first)));
                value = std::min(first << doublings, static_cast<int>(field.range.high));
            }
        });
    }
};

/// The full program chooses at run time, so its features say little; those of its specialised twin tell them apart.
Technique specialised(Technique technique) {
    technique.program = Program::specialised;
    return technique;
}

/// Keeps techniques whose programs differ from all earlier ones; notes the others as omitted.
class Selection {
  public:
    Selection(const Scene &scene, std::vector<ObjectResources> resources)
        : scene_(scene), resources_(std::move(resources)) {}

    [[nodiscard]] bool has(const Technique &technique) const {
        return std::ranges::any_of(rows, [&](const auto &row) { return row.first == technique; });
    }
    void add(const Technique &technique, RowGroup group) {
        if (why_refused(technique)) {
            return; // no such technique
        }
        const auto features = object_features(scene_, specialised(technique), resources_);
        for (const auto &[other, its_features] : kept_) {
            if (other.program == technique.program && its_features == features) {
                omitted.push_back({to_string(technique), std::string(same_program) + to_string(other)});
                return;
            }
        }
        kept_.emplace_back(technique, features);
        rows.emplace_back(technique, group);
    }

    std::vector<std::pair<Technique, RowGroup>> rows;
    std::vector<OmittedRow> omitted;

  private:
    const Scene &scene_;
    std::vector<ObjectResources> resources_;
    std::vector<std::pair<Technique, std::vector<Features>>> kept_;
};

void for_frequencies_and_models(const std::function<void(const Technique &)> &visit) {
    for (const Model model : all_models) {
        for (const Frequency frequency : all_frequencies) {
            Technique technique;
            technique.frequency = frequency;
            technique.model = model;
            visit(technique);
        }
    }
}

/// Adds the full program, the shortcuts and the other powers of every technique that was selected.
void add_variants(Selection &selection) {
    for_frequencies_and_models([&](const Technique &t) {
        if (!selection.has(t) || t.frequency == Frequency::automatic) { // its parts have theirs
            return;
        }
        const auto variant = [&](auto member, auto value, RowGroup group) {
            Technique changed = t;
            changed.*member = value;
            selection.add(changed, group);
        };
        variant(&Technique::program, Program::full, RowGroup::full_program);
        variant(&Technique::program, Program::baked, RowGroup::baked_program);
        if (t.frequency == Frequency::per_pixel) {
            variant(&Technique::precision, Precision::medium, RowGroup::precision);
        }
        variant(&Technique::attenuation, AttenuationAt::interpolated, RowGroup::claim);
        variant(&Technique::attenuation, AttenuationAt::distance_interpolated, RowGroup::claim);
        if (!reflection(t.model).specular || t.frequency == Frequency::flat) {
            return; // no exponent and no viewer; no smooth picture
        }
        variant(&Technique::viewer, Viewer::infinite, RowGroup::claim);
        variant(&Technique::half_vector, HalfVector::constant, RowGroup::claim);
        if (t.frequency == Frequency::per_pixel) {
            variant(&Technique::power, Power::textbook, RowGroup::power);
            variant(&Technique::power, Power::stable, RowGroup::power);
        }
    });
}

std::size_t triangles_of(const std::vector<ObjectResources> &resources) {
    std::size_t count = 0;
    for (const ObjectResources &own : resources) {
        count += own.mesh->triangles.size();
    }
    return count;
}

std::vector<PlannedMesh> plan_meshes(const Scene &scene, const PlanOptions &options, const Load &load) {
    std::vector<PlannedMesh> meshes;
    if (leading_rings(scene)) {
        for (int rings = options.first_rings; rings <= options.last_rings; rings *= 2) {
            PlannedMesh mesh{rings, false, true, 0, with_rings(scene, rings, options.first_rings)};
            mesh.own = mesh.scene == scene;
            meshes.push_back(std::move(mesh));
        }
    }
    if (std::ranges::none_of(meshes, &PlannedMesh::own)) {
        meshes.insert(meshes.begin(), PlannedMesh{0, true, false, 0, scene});
    }
    for (PlannedMesh &mesh : meshes) {
        mesh.triangles = triangles_of(load(mesh.scene));
    }
    return meshes;
}

} // namespace

PlanOptions quick_plan() { return {{320, 240}, 8, 64, 4, 5}; }

Scene with_rings(const Scene &scene, int rings, int first_rings) {
    const auto lead = leading_rings(scene);
    if (!lead) {
        return scene;
    }
    int doublings = 0;
    while (first_rings << doublings < rings) {
        ++doublings;
    }
    const Rescale to{first_rings / *lead, doublings};
    Scene rescaled = scene;
    for (Object &object : rescaled.objects) {
        std::visit(to, object.mesh);
    }
    return rescaled;
}

Plan plan_report(const Scene &scene, const PlanOptions &options, const Load &load) {
    Plan plan;
    plan.meshes = plan_meshes(scene, options, load);
    Selection selection(scene, load(scene));
    for (const Technique &technique : options.only) {
        selection.add(technique, RowGroup::ladder);
    }
    if (options.only.empty()) {
        for_frequencies_and_models([&](const Technique &t) { selection.add(t, RowGroup::ladder); });
    }
    const auto base = selection.rows;
    if (options.only.empty()) {
        add_variants(selection);
    }
    for (std::size_t m = 0; m < plan.meshes.size(); ++m) {
        const auto &rows = plan.meshes[m].own ? selection.rows : base;
        for (const auto &[technique, group] : rows) {
            const bool between = group == RowGroup::ladder && !plan.meshes[m].ladder;
            plan.rows.push_back({m, technique, between ? RowGroup::own_mesh : group});
        }
    }
    plan.omitted = selection.omitted;
    return plan;
}

} // namespace sandbox
