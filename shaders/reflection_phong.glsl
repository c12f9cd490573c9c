// Phong 1975: f^n with f = R.L, L the direction to the light and R the mirrored direction to the viewer, both unit.
float phong(vec3 R, vec3 L)
{
#if exponent_stable
    vec3 chord = R - L; // half its square is 1 - f
    return dot(R, L) > 0.0 ? stable_power(0.5 * dot(chord, chord), shininess) : 0.0;
#elif exponent_one
    return max(dot(R, L), 0.0);
#elif exponent_whole
    float f = max(dot(R, L), 0.0);
    float ${squares};
    return ${product};
#elif power_naive && !full
    return pow(max(dot(R, L), 0.0), shininess); // Fault: undefined where both are 0.
#else
    return pow(max(dot(R, L), 0.0), shininess);
#endif
}

