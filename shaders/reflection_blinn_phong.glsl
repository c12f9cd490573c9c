// Blinn 1977: f^n with f = N.H, H the half vector between L and V${half_vector}.
float blinn_phong(vec3 N, vec3 H)
{
#if power_naive && !full
    return pow(max(dot(N, normalize(H)), 0.0), shininess); // Fault: H may be 0, and so may f and n.
#else
    float h2 = dot(H, H);
#if exponent_stable
    vec3 sine = cross(N, H); // its square over h2 is 1 - f^2
    return ${where_H}(dot(N, H) > 0.0 ? stable_power(dot(sine, sine) / h2, 0.5 * shininess) : 0.0)${else_N};
#elif exponent_one
    return ${where_H}max(dot(N, H), 0.0) * inversesqrt(h2)${else_N};
#elif exponent_odd || precision_medium && !full
    float f = ${where_H}max(dot(N, H), 0.0) * inversesqrt(h2)${else_N};
#if exponent_odd
    float ${squares};
    return ${product};
#else
    return pow(f, shininess);
#endif
#else
    float c = max(dot(N, H), 0.0);
    float f2 = ${where_H}c * c / h2${else_N}; // the square of f: no root is taken
#if exponent_two
    return f2;
#elif exponent_whole
    float ${squares_of_f2};
    return ${product};
#else
    return pow(f2, 0.5 * shininess);
#endif
#endif
#endif
}

