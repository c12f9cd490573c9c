#pragma once

#include <string_view>

namespace sandbox {
struct Object;
struct Scene;
struct Technique;
} // namespace sandbox

/// The rules that the rows of the technique table name.
namespace sandbox::rules {

/// Why a value has no meaning beside the technique's other keys; empty where it has one.
using Refusal = std::string_view (*)(const Technique &);

std::string_view needs_unit_normals_per_pixel(const Technique &technique);
std::string_view needs_specular(const Technique &technique);
std::string_view needs_half_vector(const Technique &technique);
std::string_view needs_attenuation_per_pixel(const Technique &technique);
std::string_view needs_exact_distances(const Technique &technique);
/// The model `own`: some frequencies, no other key, and a text.
std::string_view needs_own_text(const Technique &technique);
std::string_view needs_specialised_program(const Technique &technique);
std::string_view needs_rounded_pixels(const Technique &technique);

/// Can a value change the picture of `object`? Where the answer is no, the reference draws it bit for bit as with the
/// key's default. `technique` holds the other keys. A term counts where no factor that the scene gives it is 0.
using CanMatter = bool (*)(const Scene &scene, const Object &object, const Technique &technique);

bool reads_view(const Scene &scene, const Object &object, const Technique &technique);
bool has_light(const Scene &scene, const Object &object, const Technique &technique);
bool has_diffuse_or_specular(const Scene &scene, const Object &object, const Technique &technique);
bool has_specular(const Scene &scene, const Object &object, const Technique &technique);
bool has_light_ambient(const Scene &scene, const Object &object, const Technique &technique);
bool has_directional_diffuse(const Scene &scene, const Object &object, const Technique &technique);
/// A normal is read, and the model matrix does more to it than scale its length.
bool scales_normals_unevenly(const Scene &scene, const Object &object, const Technique &technique);
bool transforms_normals(const Scene &scene, const Object &object, const Technique &technique);
/// The object is two-sided, and a normal is read.
bool turns_normals(const Scene &scene, const Object &object, const Technique &technique);
bool mirrors_normals(const Scene &scene, const Object &object, const Technique &technique);
/// ... and the camera is turned.
bool turns_normals_to_view(const Scene &scene, const Object &object, const Technique &technique);
/// Would N be any longer or shorter if nothing made it unit?
bool reads_normal_lengths(const Scene &scene, const Object &object, const Technique &technique);
bool reads_normals_per_pixel(const Scene &scene, const Object &object, const Technique &technique);
/// Something depends on where the object's points are.
bool reads_positions(const Scene &scene, const Object &object, const Technique &technique);
/// ... and the object is translated.
bool reads_translation(const Scene &scene, const Object &object, const Technique &technique);
bool attenuates_per_pixel(const Scene &scene, const Object &object, const Technique &technique);
/// Some exponent that is raised is one for which power=auto takes the stable form.
bool raises_large_exponents(const Scene &scene, const Object &object, const Technique &technique);
/// ... or the textbook's.
bool raises_small_exponents(const Scene &scene, const Object &object, const Technique &technique);

} // namespace sandbox::rules
