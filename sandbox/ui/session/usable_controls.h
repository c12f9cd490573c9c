#pragma once

#include "scene/scene_format.h"
#include "shading/technique.h"

/// What can change the picture of a scene under either of two techniques: only these properties get a control. A term
/// at 0 keeps its slider: what counts is that the equation reads it.
namespace sandbox {

/// The parts of the equation that a scene's lights and the two techniques evaluate.
struct Terms {
    bool light = false;
    bool highlight = false;
    bool blinn_highlight = false;
    [[nodiscard]] bool have(Term term) const;
};
Terms terms_of(const Scene &scene, const Technique &left, const Technique &right);

/// Does anything read this property? A light that is off counts as absent.
template <class T, class M> bool is_usable(const Field<T, M> &field, const T &value, const Terms &terms) {
    if constexpr (std::is_same_v<T, Light>) {
        if (!value.enabled) {
            return false;
        }
    }
    return field.rules.used(value) && terms.have(field.rules.term);
}

/// What one value of a technique key is good for, under the other keys of a technique.
enum class ValueUse {
    refused,   ///< the frequency, the model or another key rules it out
    no_effect, ///< nothing in this scene shows it
    open
};
ValueUse value_use(const TechniqueKey &key, int value, const Scene &scene, Technique technique);
/// May the value be clicked? Where it is open, and where it is set, so that it can be seen and left.
bool value_open(const TechniqueKey &key, int value, const Scene &scene, const Technique &technique);

} // namespace sandbox
