// v made unit, whatever its length; `otherwise` where nothing is left of it.
vec3 guarded_unit(vec3 v, vec3 otherwise)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    float scale = uintBitsToFloat(floatBitsToUint(largest) & 0x7F800000u); // a power of two: dividing by it is exact
    return scale > 0.0 ? normalize(v / scale) : otherwise;
}
