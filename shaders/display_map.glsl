#if exposed
uniform float exposure;
#endif

#if srgb
// IEC 61966-2-1
vec3 srgb_curve(vec3 x)
{
    return mix(12.92 * x, 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, greaterThan(x, vec3(0.0031308)));
}

#endif
// What a screen shows of light that is finite.
vec3 displayed(vec3 light)
{
#if exposed
    light *= exposure;
#endif
    vec3 shown = clamp(light, 0.0, 1.0);
#if srgb
    shown = srgb_curve(shown);
#endif
    return shown;
}
