#define TWICE 2
struct Terms { vec3 diffuse; float share; };
const float weights[3] = float[3](1.0, 0.5, 0.25);
vec3 one(Light light, vec3 P, vec3 N) {
    vec3 L = light.position - P;
    return light.color * max(dot(N, normalize(L)), 0.0) / (1.0 + dot(L, L));
}
vec3 position(vec3 p) { return (model * vec4(p, 1.0)).xyz; }
vec3 normal(vec3 n) { return normal_matrix * n; }
vec3 lighting(vec3 P, vec3 N, vec3 eye) {
    vec3 sum = vec3(0.0); // a comment
    for (int i = 0; i < light_count; ++i) { sum += one(lights[i], P, normalize(N)); }
    int turns = 0;
    while (turns < TWICE) { turns++; if (turns > 3) { break; } else { continue; } }
    Terms terms = Terms(sum * material.diffuse * base(), weights[1]);
    return terms.diffuse * terms.share;
}
