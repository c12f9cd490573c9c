// A half-float device, made of float32: after every operation h() rounds to IEEE half, to nearest even. What lies beyond
// 65504 becomes infinite and what half would hold as a subnormal, below 2^-14, becomes 0.
float h(float x)
{
    uint bits = floatBitsToUint(x);
    uint size = bits & 0x7fffffffu;
    uint kept = (size + 0x0fffu + ((size >> 13) & 1u)) & 0xffffe000u; // 11 of 24 digits
    kept = kept > 0x477fe000u ? 0x7f800000u : max(kept, 0x38800000u);
    kept = size < 0x387fe000u ? 0u : kept; // what rounds to a subnormal
    return size > 0x7f800000u ? x : uintBitsToFloat(bits & 0x80000000u | kept);
}

vec2 h(vec2 v)
{
    return vec2(h(v.x), h(v.y));
}

vec3 h(vec3 v)
{
    return vec3(h(v.x), h(v.y), h(v.z));
}

vec4 h(vec4 v)
{
    return vec4(h(v.xyz), h(v.w));
}

// GLSL's own functions, operation by operation in written order.
float h_dot(vec3 a, vec3 b)
{
    vec3 c = h(a * b);
    return h(h(c.x + c.y) + c.z);
}

float h_length(vec3 v)
{
    return h(sqrt(h_dot(v, v)));
}

vec3 h_normalize(vec3 v)
{
    return h(v / h_length(v));
}

vec3 h_cross(vec3 a, vec3 b)
{
    return h(h(a.yzx * b.zxy) - h(a.zxy * b.yzx));
}

vec3 h_reflect(vec3 i, vec3 n)
{
    return h(i - h(h(2.0 * h_dot(n, i)) * n));
}

float h_pow(float x, float n)
{
    return x > 0.0 ? h(exp2(h(n * h(log2(x))))) : 0.0;
}

float h_mod(float x, float y)
{
    return h(x - h(y * floor(h(x / y))));
}

float h_smoothstep(float low, float high, float x)
{
    float t = clamp(h(h(x - low) / h(high - low)), 0.0, 1.0);
    return h(h(t * t) * h(3.0 - h(2.0 * t)));
}

