#pragma once

#include "reference/kept_values.h"
#include "scene/scene.h"
#include "scene/unit.h"
#include "shading/technique.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

/// The shading equations in double, one function a formula, for any point. Everything is measured from the eye
/// (world axes, origin at the camera), so that scenes far from the world's origin lose nothing; colours are linear RGB.
///
/// Where the equations leave a choice:
/// - unit(0) = 0: a direction that does not exist lights nothing (an interpolated normal that cancels, V at the eye).
/// - half_vector=constant: H = unit(unit(light position from the world's origin, or -direction) + view axis), the view
///   axis being -camera forward.
/// - ambient=where-lit drops a light's own ambient term; the scene's ambient stays.
/// - position=absolute rounds world positions, the eye and lights to float32 and goes on in double.
/// - normals=unnormalized: a cosine with N is as long as N.
/// - direction=unnegated-diffuse changes the diffuse term alone; L, R, H and the gate keep the right direction.
namespace sandbox::reference {

/// Rounded to float32.
glm::dvec3 as_float(const glm::dvec3 &v);

/// max(a.b, 0)^n, with x^0 = 1 also for x = 0. Worked out from |a - b|^2 where the cosine is near 1, so that the
/// relative error stays near 1e-15 + n * 1e-16 * angle. The vectors need not be unit: their lengths count as in the dot
/// product.
double power_of_dot(const glm::dvec3 &a, const glm::dvec3 &b, double n);

/// 1 / max(kc + kl d + kq d^2, 1e-6), d in world units.
double attenuation(const Attenuation &k, double d);

/// A light and what follows from it once per picture.
struct LightSetup {
    Light light;
    glm::dvec3 position{0};      ///< from the eye; of a positional light
    glm::dvec3 travel{0};        ///< unit(direction)
    bool cone = false;           ///< a spot whose cutoff is not 180 degrees
    double cos_outer = -1;       ///< cos(cutoff)
    double cos_inner = -1;       ///< cos(inner cutoff); equal to cos_outer: a hard edge
    glm::dvec3 constant_half{0}; ///< H under half_vector=constant
};

/// What the equation needs of a scene and a technique at every point. Lights that are off are left out.
struct Setup {
    Technique technique;
    glm::dvec3 eye{0};             ///< world space: what everything here is measured from
    glm::dvec3 view_axis{0, 0, 1}; ///< -camera forward
    glm::dmat3 to_view{1};         ///< from world axes to the camera's: right, up, back
    glm::dvec3 origin{0};      ///< what positions are measured from in float32, from the eye: the world's origin under
                               ///< position=absolute
    bool orthographic = false; ///< V is the view axis at every point
    glm::dvec3 ambient{0};
    double blinn_exponent_scale = 1;
    HighValues high; ///< of precision=medium: what is declared highp all the same
    std::vector<LightSetup> lights;
    std::vector<std::size_t> light_index; ///< of lights[i] in the scene's list
};
Setup prepare(const Scene &scene, const Technique &technique);

/// V at p, by the viewer key and the camera.
glm::dvec3 view_vector(const Setup &setup, const glm::dvec3 &p);

/// The vectors of one light as the equation meets them: exact at a point, or as interpolated over a triangle.
struct LightVectors {
    glm::dvec3 l{0}; ///< unit, to the light
    double d = 0;    ///< distance, world units; 0 for directional
    double a = 1;    ///< attenuation
    glm::dvec3 r{0}; ///< 2 (N.L) N - L; Phong
    glm::dvec3 h{0}; ///< unit(L + V), N where L = -V; Blinn-Phong
    /// Of an interpolated L, and of R or H, before they were made unit: of what nearly cancels float32 keeps little.
    double l_length = 1, highlight_length = 1;
};
LightVectors light_vectors(const Setup &setup, const LightSetup &light, const glm::dvec3 &p, const glm::dvec3 &n,
                           const glm::dvec3 &v);

/// The unit vectors whose cosine is f: R and V, or N and H; 0 where the model has no specular term.
std::pair<glm::dvec3, glm::dvec3> highlight_vectors(Model model, const LightVectors &vectors, const glm::dvec3 &n,
                                                    const glm::dvec3 &v);
/// The exponent: n, or n_B under Blinn-Phong.
double raised_exponent(const Setup &setup, double shininess);
/// What normalisation=blinn-phong multiplies S by; 1 without it.
double highlight_scale(const Setup &setup, double shininess);

/// Every intermediate of one light at one point. ambient, diffuse and specular are A_i, D_i, S_i: no material yet.
struct LightTerms {
    LightVectors vectors;
    double n_dot_l = 0;
    double c = 1;        ///< spot: dot(-L, unit(D))
    double s = 1;        ///< spot factor
    double s_uncut = 1;  ///< the spot factor as if the cone did not end: max(c, 0)^exponent
    double f = 0;        ///< max(R.V, 0) or max(N.H, 0)
    double exponent = 0; ///< n, or n_B under Blinn-Phong
    double f_power = 0;  ///< f^n
    bool gate = false;   ///< does the specular term pass?
    glm::dvec3 ambient{0};
    glm::dvec3 diffuse{0};
    glm::dvec3 specular{0};
};
LightTerms light_terms(const Setup &setup, const LightSetup &light, const LightVectors &vectors, const glm::dvec3 &n,
                       const glm::dvec3 &v, double shininess);

/// The reflected light before the surface's own colour `base` is known: base comes per pixel under every frequency.
struct Reflected {
    glm::dvec3 body{0};      ///< m_a (scene.ambient + sum A) + m_d sum D
    glm::dvec3 highlight{0}; ///< m_s sum S
};

/// emission + base * body + (texture_modulates_specular ? base : 1) * highlight
glm::dvec3 compose(const Material &material, const glm::dvec3 &base, const Reflected &reflected);

/// Which side of a surface is seen. Of a triangle the back is the one whose corners run clockwise on the screen, or
/// counter-clockwise if the object's transform has a determinant below 0.
enum class Side { front, back };

/// N as the equation takes it: of a two-sided object turned where its back is seen or, under facing=view, N.V < 0.
glm::dvec3 facing(const Setup &setup, bool two_sided, const glm::dvec3 &n, const glm::dvec3 &v, Side side);

} // namespace sandbox::reference
