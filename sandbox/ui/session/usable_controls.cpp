#include "ui/session/usable_controls.h"

#include <algorithm>

namespace sandbox {

bool Terms::have(Term term) const {
    switch (term) {
    case Term::any:
        return true;
    case Term::light:
        return light;
    case Term::highlight:
        return highlight;
    case Term::blinn_highlight:
        return blinn_highlight;
    }
    return false;
}

Terms terms_of(const Scene &scene, const Technique &left, const Technique &right) {
    const Reflection a = reflection(left.model);
    const Reflection b = reflection(right.model);
    const bool light = std::ranges::any_of(scene.lights, &Light::enabled);
    return {light, light && (a.specular || b.specular), light && (a.scaled_exponent || b.scaled_exponent)};
}

ValueUse value_use(const TechniqueKey &key, int value, const Scene &scene, Technique technique) {
    key.set(technique, value);
    technique.tolerance = technique.frequency == Frequency::automatic ? technique.tolerance : default_tolerance;
    if (why_refused(technique)) {
        return ValueUse::refused;
    }
    return can_matter(key, value, scene, technique) ? ValueUse::open : ValueUse::no_effect;
}

bool value_open(const TechniqueKey &key, int value, const Scene &scene, const Technique &technique) {
    return key.get(technique) == value || value_use(key, value, scene, technique) == ValueUse::open;
}

} // namespace sandbox
