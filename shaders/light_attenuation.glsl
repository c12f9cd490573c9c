#if light.finds_attenuation && light.floor
    float a = 1.0 / max(${light.denominator}, 1e-6);
#elif light.finds_attenuation
    float a = 1.0 / (${light.denominator});
#endif
