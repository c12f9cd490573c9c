#each array
#if array.declared
struct ${array.type} {
#if array.positional
#if position_absolute && !full
    vec3 position; // Fault: in world space, far from whose origin float32 is coarse
#elif off_eye && !full
    vec3 position; // from the object's middle
#else
    vec3 position; // from the eye
#endif
#endif
#if array.directed
    vec3 direction; // unit, the way light travels
#endif
#if array.ambient
    vec3 ambient; // material times light
#endif
#if array.attenuated_ambient
    vec3 attenuated_ambient; // material times light, fades
#endif
#if array.diffuse
#if normalisation_blinn_phong && !full
    vec3 diffuse; // material times light, over pi
#else
    vec3 diffuse; // material times light
#endif
#endif
#if array.one_color && !array.one_share
    float specular_share; // the specular light is so many times the diffuse
#elif array.specular && !array.one_share
#if normalisation_blinn_phong && !full
    vec3 specular; // material times light times (n + 8) / (8 pi)
#else
    vec3 specular; // material times light
#endif
#endif
#if array.given_half_vector
    vec3 half_vector;
#endif
#if array.constant && !array.one_attenuation
    float constant; // attenuation
#endif
#if array.linear && !array.one_attenuation
    float linear;
#endif
#if array.quadratic && !array.one_attenuation
    float quadratic;
#endif
#if array.cone
    float cos_cutoff;
#endif
#if array.narrow_cone
    float sin2_cutoff; // the square of the cutoff's sine
#endif
#if array.soft_cone && array.narrow_cone
    float edge_sharpness; // 1 over the width of the edge, in cosines; 0: hard
#endif
#if array.soft_cone && !array.narrow_cone || full
    float cos_inner_cutoff;
#endif
#if array.exponent
    float exponent;
#endif
};
#if array.many
uniform ${array.type} ${array.array}[${array.count}];
#else
uniform ${array.type} the_${array.kind}_light;
#endif
#if array.one_share
uniform float ${array.kind}_specular_share; // the specular light of each is so many times the diffuse
#endif
#if array.one_attenuation && array.constant
uniform float ${array.kind}_constant; // the attenuation of each
#endif
#if array.one_attenuation && array.linear
uniform float ${array.kind}_linear;
#endif
#if array.one_attenuation && array.quadratic
uniform float ${array.kind}_quadratic;
#endif

#endif
#end
#if full
#each light
uniform int ${light.first}, ${light.end}; // where these lights begin and end in the array
#end
#endif
