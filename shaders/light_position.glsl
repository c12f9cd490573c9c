#if light.finds_L || light.finds_distance
    vec3 to_light = light.position - P;
#endif
#if light.finds_distance
    float d = length(to_light);
#endif
#if light.finds_L && light.on_surface && light.finds_distance
    vec3 L = d > 0.0 ? to_light / d : N; // the light may touch the surface
#elif light.finds_L && light.on_surface
    vec3 L = to_light != vec3(0.0) ? normalize(to_light) : N; // the light may touch the surface
#elif light.finds_L && light.finds_distance
    vec3 L = to_light / d;
#elif light.finds_L
    vec3 L = normalize(to_light);
#elif light.given_L && light.uses_L
    vec3 L = normalize(direction);
#endif
