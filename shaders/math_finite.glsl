// By the bits: GLSL promises nothing about comparisons with NaN.
bool finite(vec3 value)
{
    return all(lessThan(floatBitsToUint(value) & 0x7fffffffu, uvec3(0x7f800000u)));
}
