// Every light and every switch of the lighting equation, chosen by uniforms.
struct Light {
    int type; // 0 directional, 1 point, 2 spot
    vec3 position; // from the eye
    vec3 direction; // unit, the way light travels
    vec3 ambient; // material times light
    vec3 attenuated_ambient;
    vec3 diffuse;
    vec3 specular;
    vec3 half_vector;
    float constant; // attenuation
    float linear;
    float quadratic;
    float cos_cutoff;
    float cos_inner_cutoff;
    float sin2_cutoff; // the square of the cutoff's sine
    float edge_sharpness; // 1 over the width of the edge, in cosines; 0: hard
    float exponent;
};
uniform Light lights[${full.lights}];
uniform int light_count;
uniform vec3 ambient; // all constant ambient light, times the material
uniform float shininess; // the exponent n
uniform int model_kind; // 0 Lambert, 1 Phong, 2 Blinn-Phong
uniform int power_kind; // 0 by the exponent, 1 pow(), 2 stable
uniform int gate; // 0 N.L > 0, 1 N.V > 0, 2 none
uniform bool half_vector_constant;
uniform bool viewer_infinite;
#if hybrid
const bool base_times_specular = false; // diffuse and specular light are found in different stages
#else
uniform bool base_times_specular; // or there is no base colour
#endif
uniform bool ambient_where_lit;
uniform bool unnegated_diffuse;

#include "power_stable.glsl"
// Does f^n want the stable form? That measures an angle between unit vectors.
bool is_stiff(float n, bool unit_vectors)
{
    return unit_vectors && (power_kind == 2 || (power_kind == 0 && n >= 1024.0));
}

// f^n from a cosine and the square of its sine (Blinn-Phong, cones).
float cosine_power(float cosine, float sine2, float n, bool unit_vectors)
{
    if (n == 0.0 || n == 1.0) {
        return n == 0.0 ? 1.0 : max(cosine, 0.0);
    }
    if (is_stiff(n, unit_vectors)) {
        return cosine > 0.0 ? stable_power(sine2, 0.5 * n) : 0.0;
    }
    return pow(max(cosine, 0.0), n);
}

float blinn_phong(vec3 N, vec3 H, bool unit_normal)
{
    float h2 = dot(H, H);
    vec3 sine = cross(N, H);
    return h2 > 0.0 ? cosine_power(dot(N, H) * inversesqrt(h2), dot(sine, sine) / h2, shininess, unit_normal) : 1.0;
}

float phong(vec3 R, vec3 L, bool unit_vectors)
{
    float f = dot(R, L);
    if (shininess == 0.0 || shininess == 1.0) {
        return shininess == 0.0 ? 1.0 : max(f, 0.0);
    }
    if (is_stiff(shininess, unit_vectors)) {
        vec3 chord = R - L;
        return f > 0.0 ? stable_power(0.5 * dot(chord, chord), shininess) : 0.0;
    }
    return pow(max(f, 0.0), shininess);
}

float cone(Light light, vec3 L)
{
    float c = dot(-L, light.direction);
    vec3 sine = cross(L, light.direction); // its square is 1 - c^2
    float inside = c - light.cos_cutoff;
    float edge = light.edge_sharpness > 0.0
        ? smoothstep(light.cos_cutoff, light.cos_inner_cutoff, c)
        : (inside < 0.0 ? 0.0 : 1.0);
    if (c > 0.5 && (light.cos_cutoff > 0.9994 || light.edge_sharpness > 1666.0)) { // cosines near 1 have no digits left
        inside = (light.sin2_cutoff - dot(sine, sine)) / (c + light.cos_cutoff);
        edge = light.edge_sharpness > 0.0 ? smoothstep(0.0, 1.0, inside * light.edge_sharpness) : float(inside >= 0.0);
    }
    return edge * cosine_power(c, dot(sine, sine), light.exponent, true);
}

float attenuation(Light light, float d)
{
    return 1.0 / max(light.constant + light.linear * d + light.quadratic * d * d, 1e-6);
}

// One light's terms; `highlight` is its f^n, d the distance. Adds to `multiplied` what the base colour multiplies.
void add_light(Light light, vec3 N, vec3 V, vec3 L, float d, float highlight, inout vec3 multiplied, inout vec3 specular)
{
    float strength = light.type == 0 ? 1.0 : attenuation(light, d);
    if (light.type == 2) {
        strength *= cone(light, L);
    }
    float n_dot_l = dot(N, L);
    float facing = unnegated_diffuse && light.type == 0 ? -n_dot_l : n_dot_l;
    float lit = !ambient_where_lit || n_dot_l > 0.0 ? 1.0 : 0.0;
    bool open = gate == 0 ? n_dot_l > 0.0 : (gate == 1 ? dot(N, V) > 0.0 : true);
    vec3 shine = light.specular * (open ? highlight : 0.0);
    vec3 faded = lit * light.attenuated_ambient + light.diffuse * max(facing, 0.0);
    multiplied += lit * light.ambient + strength * (base_times_specular ? faded + shine : faded);
    specular += base_times_specular ? vec3(0.0) : strength * shine;
}

vec3 direction_to_light(Light light, vec3 to_light, vec3 N)
{
    if (light.type == 0) {
        return -light.direction;
    }
    return to_light != vec3(0.0) ? to_light / length(to_light) : N; // the light may touch the surface
}

// H of any length.
vec3 half_vector(Light light, vec3 L, vec3 V)
{
    bool given = half_vector_constant || (viewer_infinite && light.type == 0);
    return given ? light.half_vector : L + V;
}

void add_all_lights(vec3 P, vec3 N, vec3 V, bool unit_normal, inout vec3 multiplied, inout vec3 specular)
{
    vec3 R = reflect(-V, N); // the mirrored view
    for (int i = 0; i < light_count; ++i) {
        vec3 to_light = lights[i].position - P;
        vec3 L = direction_to_light(lights[i], to_light, N);
        float highlight = 0.0;
        if (model_kind == 1) {
            highlight = phong(R, L, unit_normal);
        } else if (model_kind == 2) {
            highlight = blinn_phong(N, half_vector(lights[i], L, V), unit_normal);
        }
        add_light(lights[i], N, V, L, length(to_light), highlight, multiplied, specular);
    }
}
