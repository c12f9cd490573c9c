#pragma once

#include "ui/session/document.h"

#include <cstddef>

/// Edits that change several numbers together, so that the scene file stays valid.
namespace sandbox {

constexpr std::size_t most_lights_of_a_type = 8;

std::size_t count_lights(const Scene &scene, LightType type);
/// False if there are 8 of this type, or 64 lights in all, which is what a scene file holds.
bool can_add_light(const Scene &scene, LightType type);
/// Appends a white light above the camera's right shoulder that shines on the target. Does nothing if !can_add_light().
void add_light(Scene &scene, LightType type);
/// Turns all lights of a type on or off; adds one if there is none to turn on.
void switch_lights(Scene &scene, LightType type, bool on);

/// Keeps the light on what it shone on: a point light that becomes directional still shines at the camera's target.
void set_type(Light &light, LightType type, const Camera &camera);
/// Cutoff in degrees, [0, 90], or 180: no cone. The inner cutoff stays below it; a hard edge stays hard.
void set_cutoff(Light &light, double degrees);
/// Keeps at least one coefficient above 0.
void keep_attenuation_valid(Attenuation &attenuation);
/// After single numbers of `before` have been edited: restores the rules that tie them together.
void keep_valid(Light &light, const Light &before);

/// Sets a technique key; keys that can then have no effect go back to their defaults.
void set_key(Technique &technique, const TechniqueKey &key, int value);
/// Restores the camera as it was opened.
void reset_camera(Document &document);

} // namespace sandbox
