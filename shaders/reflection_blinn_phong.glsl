#if power_naive && !full
// Blinn 1977: f^n with f = N.H, H the half vector between L and V.
float blinn_phong(vec3 N, vec3 H)
{
    return pow(max(dot(N, normalize(H)), 0.0), shininess); // Fault: H may be 0, and so may f and n.
}
#else
// Blinn 1977: f^n with f = N.H, H the half vector between L and V, here of any length. H = N where L = -V.
float blinn_phong(vec3 N, vec3 H)
{
    float h2 = dot(H, H);
#if exponent_stable
    vec3 sine = cross(N, H); // its square over h2 is 1 - f^2
    return h2 > 0.0 ? (dot(N, H) > 0.0 ? stable_power(dot(sine, sine) / h2, 0.5 * shininess) : 0.0) : 1.0;
#else
    float f = h2 > 0.0 ? max(dot(N, H), 0.0) * inversesqrt(h2) : 1.0;
#if exponent_one
    return f;
#elif exponent_whole
    float ${squares};
    return ${product};
#else
    return pow(f, shininess);
#endif
#endif
}
#endif

