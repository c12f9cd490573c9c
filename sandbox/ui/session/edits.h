#pragma once

#include "ui/session/document.h"

#include <cstddef>

/// Edits that touch more than one number, so that what they leave behind is a scene that the reader accepts.
namespace sandbox {

constexpr std::size_t most_lights_of_a_type = 8;

std::size_t count_lights(const Scene &scene, LightType type);
/// Room for one more, of its type and in all (a scene file holds 64)?
bool can_add_light(const Scene &scene, LightType type);
/// Appends a white light above the camera's right shoulder that shines on the target. Nothing if there is no room.
void add_light(Scene &scene, LightType type);
/// All lights of a type on or off; on, where the scene has none of them, adds one.
void switch_lights(Scene &scene, LightType type, bool on);

/// Keeps where the light shines: a lamp that becomes directional goes on shining at the camera's target, and so on.
void set_type(Light &light, LightType type, const Camera &camera);
/// cutoff in degrees, [0, 90], or 180: no cone. The inner cone stays inside; a hard edge stays hard.
void set_cutoff(Light &light, double degrees);
/// At least one coefficient stays above 0.
void keep_attenuation_valid(Attenuation &attenuation);

/// Sets a technique key; keys that can then have no effect go back to their defaults.
void set_key(Technique &technique, const TechniqueKey &key, int value);
/// The scene's own camera, fov and clip planes as they were opened.
void reset_camera(Document &document);

} // namespace sandbox
