#include "teach/marking/units.h"

#include <algorithm>
#include <utility>

namespace sandbox {
namespace {

constexpr MarkTerm multipliers[]{MarkTerm::attenuation, MarkTerm::cone, MarkTerm::normals};

bool is_light_term(MarkTerm term) {
    return std::ranges::any_of(light_terms, [&](const LightTerm &row) { return row.term == term; });
}

/// What is judged by itself is made neutral where other terms are judged.
MarkTerms neutral_beside(const Exercise &exercise, MarkTerm judged) {
    MarkTerms others;
    for (const MarkTerm term : multipliers) {
        if (term != judged && exercise.find(term) != nullptr) {
            others.insert(term);
        }
    }
    return others;
}

Part::Pair lit_by(const Scene &scene, std::size_t light, MarkTerm carrier) {
    return {only_light(scene, light, {carrier}), dark(scene)};
}

/// Of one light of a scene that is neutral but for the term.
Unit unit_of(const Exercise &exercise, MarkTerm term, const Scene &scene, std::size_t light) {
    Unit unit;
    unit.light = light;
    if (is_light_term(term)) {
        unit.parts.push_back({term, lit_by(scene, light, term), {}, true, term == carriers_of(exercise).front(), {}});
        return unit;
    }
    const Scene plain = neutral(scene, {term});
    for (const MarkTerm carrier : carriers_of(exercise)) {
        const bool ambient = carrier == MarkTerm::ambient;
        if (!light_has(scene.lights[light], carrier) || (ambient && term == MarkTerm::normals)) {
            continue;
        }
        Part part{carrier, lit_by(scene, light, carrier), {}, true, false, {}};
        if (term == MarkTerm::normals) {
            part.needs = lit_by(plain, light, carrier);
        } else {
            part.plain = lit_by(plain, light, carrier);
            part.decides = !ambient || scene.lights[light].attenuate_ambient;
        }
        unit.parts.push_back(std::move(part));
    }
    return unit;
}

bool turns_or_scales(const Scene &scene) { return !(neutral(scene, {MarkTerm::normals}) == scene); }

template <class Visit> void for_each_judged(const Exercise &exercise, Visit visit) {
    for (std::size_t i = 0; i < exercise.scenes.size(); ++i) {
        if (!exercise.scenes[i].stiff) {
            visit(i, exercise.scenes[i].scene);
        }
    }
}

} // namespace

std::vector<MarkTerm> carriers_of(const Exercise &exercise) {
    std::vector<MarkTerm> all, asked;
    for (const LightTerm &row : light_terms) {
        if (row.term != MarkTerm::specular || reflection(exercise.target.model).specular) {
            all.push_back(row.term);
            if (exercise.find(row.term) != nullptr) {
                asked.push_back(row.term);
            }
        }
    }
    return asked.empty() ? all : asked;
}

std::vector<Unit> units_of(const Exercise &exercise, MarkTerm term) {
    std::vector<Unit> units;
    const auto add = [&](Unit unit, std::size_t scene) {
        if (!unit.parts.empty()) {
            unit.scene = scene;
            units.push_back(std::move(unit));
        }
    };
    const MarkTerms others = neutral_beside(exercise, term);
    for_each_judged(exercise, [&](std::size_t i, const Scene &own) {
        if (term == MarkTerm::normals && !turns_or_scales(own)) {
            return;
        }
        const Scene scene = neutral(own, others);
        if (term == MarkTerm::ambient && scene.ambient != glm::dvec3(0)) {
            Unit unit;
            unit.parts.push_back({term, {only_scene_ambient(scene), dark(scene)}, {}, true, true, {}});
            add(std::move(unit), i);
        }
        for (std::size_t light = 0; light < scene.lights.size(); ++light) {
            if (scene.lights[light].enabled && light_has(scene.lights[light], term)) {
                add(unit_of(exercise, term, scene, light), i);
            }
        }
    });
    return units;
}

std::vector<SumUnit> sum_units_of(const Exercise &exercise) {
    std::vector<SumUnit> units;
    for_each_judged(exercise, [&](std::size_t i, const Scene &scene) {
        SumUnit unit{i, scene, dark(scene), {}};
        std::vector<Scene> terms, lights;
        for (const LightTerm &row : light_terms) {
            terms.push_back(only_terms(scene, {row.term}));
        }
        for (std::size_t light = 0; light < scene.lights.size(); ++light) {
            lights.push_back(only_light(scene, light, {MarkTerm::ambient, MarkTerm::diffuse, MarkTerm::specular}));
        }
        if (scene.ambient != glm::dvec3(0)) {
            lights.push_back(only_scene_ambient(scene));
        }
        for (std::vector<Scene> *split : {&terms, &lights}) {
            std::erase(*split, unit.dark);
            if (split->size() > 1) {
                unit.splits.push_back(std::move(*split));
            }
        }
        units.push_back(std::move(unit));
    });
    return units;
}

} // namespace sandbox
