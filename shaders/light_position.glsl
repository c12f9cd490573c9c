#if light.finds_L || light.finds_distance
    vec3 to_light = light.position - P;
#endif
#if light.finds_distance
    float d = length(to_light);
#endif
#if light.finds_L && light.on_surface
    vec3 L = to_light != vec3(0.0) ? to_light / ${light.distance} : N; // the light may touch the surface
#elif light.finds_L
    vec3 L = to_light / ${light.distance};
#elif light.given_L && light.uses_L
    vec3 L = normalize(direction);
#endif
