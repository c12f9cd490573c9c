struct ${light.struct} {
#if light.positional
    vec3 position; // from the eye
#endif
#if light.directed
    vec3 direction; // unit, the way light travels
#endif
#if light.ambient
    vec3 ambient; // material times light
#endif
#if light.attenuated_ambient
    vec3 attenuated_ambient; // material times light, fades
#endif
#if light.diffuse
    vec3 diffuse; // material times light
#endif
#if light.specular
    vec3 specular; // material times light
#endif
#if light.given_half_vector
    vec3 half_vector;
#endif
#if light.constant
    float constant; // attenuation
#endif
#if light.linear
    float linear;
#endif
#if light.quadratic
    float quadratic;
#endif
#if light.cone
    float cos_cutoff;
#endif
#if light.narrow_cone
    float sin2_cutoff; // the square of the cutoff's sine
#endif
#if light.soft_cone && light.narrow_cone
    float edge_sharpness; // 1 over the width of the edge, in cosines; 0: hard
#elif light.soft_cone
    float cos_inner_cutoff;
#endif
#if light.exponent
    float exponent;
#endif
};
#if light.many
uniform ${light.struct} ${light.kind}_lights[${light.count}];
#else
uniform ${light.struct} the_${light.kind}_light;
#endif

