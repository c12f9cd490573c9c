// The textbook's answer: ${model_title}, ${scene_title}
//   shading-sandbox compare ${scene} --left ${frequency}/own --own-left FILE.glsl --right ${reference}

${signature}
{
    N = normalize(N);
#if specular && orthographic
    vec3 V = view_axis;
#elif specular
    vec3 V = normalize(eye - P);
#endif
    vec3 ambient = scene_ambient;
    vec3 diffuse = vec3(0.0);
#if specular
    vec3 specular = vec3(0.0);
#endif
#if scaled
    float n = blinn_exponent_scale * material.shininess;
#elif specular
    float n = material.shininess;
#endif
    for (int i = 0; i < light_count; ++i) {
        Light light = lights[i];
#if directional && positional
        vec3 L = light.type == DIRECTIONAL ? -light.direction : normalize(light.position - P);
#elif directional
        vec3 L = -light.direction;
#else
        vec3 L = normalize(light.position - P);
#endif
#if attenuated || cone
        float fades = 1.0;
#endif
#if attenuated && directional
        if (light.type != DIRECTIONAL) {
            float d = length(light.position - P);
            fades = 1.0 / (light.constant + light.linear * d + light.quadratic * d * d);
        }
#elif attenuated
        float d = length(light.position - P);
        fades = 1.0 / (light.constant + light.linear * d + light.quadratic * d * d);
#endif
#if cone
        if (light.type == SPOT && light.cutoff_degrees < 180.0) {
            float c = dot(-L, light.direction);
#if soft && hard
            fades *= light.cos_inner_cutoff > light.cos_cutoff
                ? smoothstep(light.cos_cutoff, light.cos_inner_cutoff, c)
                : (c < light.cos_cutoff ? 0.0 : 1.0);
#elif soft
            fades *= smoothstep(light.cos_cutoff, light.cos_inner_cutoff, c);
#else
            fades *= c < light.cos_cutoff ? 0.0 : 1.0;
#endif
#if exponent
            fades *= c > 0.0 ? pow(c, light.exponent) : 0.0;
#endif
        }
#endif
        float n_dot_l = dot(N, L);
#if attenuates_ambient
        ambient += light.color * light.ambient * (light.attenuate_ambient ? fades : 1.0);
#else
        ambient += light.color * light.ambient;
#endif
#if attenuated || cone
        diffuse += light.color * light.diffuse * max(n_dot_l, 0.0) * fades;
#else
        diffuse += light.color * light.diffuse * max(n_dot_l, 0.0);
#endif
#if specular
        if (n_dot_l > 0.0) { // no highlight where the light does not reach
#if half_vector
            float f = max(dot(N, normalize(L + V)), 0.0);
#else
            float f = max(dot(reflect(-L, N), V), 0.0);
#endif
#if attenuated || cone
            specular += light.color * light.specular * pow(f, n) * fades;
#else
            specular += light.color * light.specular * pow(f, n);
#endif
        }
#endif
    }
    vec3 light = material.ambient * ambient + material.diffuse * diffuse;
#if base && specular
    vec3 shine = material.specular * specular;
    return material.emission + base() * light + (material.texture_modulates_specular ? base() : vec3(1.0)) * shine;
#elif base
    return material.emission + base() * light;
#elif specular
    return material.emission + light + material.specular * specular;
#else
    return material.emission + light;
#endif
}
