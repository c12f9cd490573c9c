#include "reference/half_numbers.h"
#include "render/probe_vectors.h"
#include "render/shader_probe.h"
#include "shading/half.h"
#include "tools/gl_test.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <functional>
#include <glm/vec3.hpp>
#include <random>

/// math_half.glsl against its twins (to_half, reference/half_numbers.h), in units in the last place of half.
namespace sandbox {
namespace {

using reference::Number;
using reference::Triple;

class HalfProbes : public GlTest {};

/// Between two halves, in steps of the larger; infinite where only one is a number.
double ulps(double got, double wanted) {
    if (got == wanted || (std::isnan(got) && std::isnan(wanted))) {
        return 0;
    }
    const double size = std::max({std::abs(got), std::abs(wanted), 0x1p-14});
    return std::abs(got - wanted) / std::ldexp(1.0, std::ilogb(size) - 10);
}

float bits_to_float(unsigned bits) { return std::bit_cast<float>(bits); }

TEST_F(HalfProbes, RoundingIsTheSameToTheLastBit) {
    std::mt19937 random(1);
    std::vector<ProbeInput> inputs;
    for (const double value : {0.0, -0.0, 1.0 / 3, 0.1, 1000.5, 2049.0, 2051.0, 65504.0, 65519.99, 65520.0, 65536.0,
                               1e30, 0x1p-14, 0x1p-14 - 0x1p-25, 0x1p-14 - 0x1p-24, 0x1p-14 - 0x1p-26, 1e-5, -1e-30}) {
        inputs.push_back({glm::vec4(static_cast<float>(value), static_cast<float>(-value), 0, 0)});
    }
    for (int i = 0; i < 20000; ++i) { // exponents of half and some on both sides, all digits
        const unsigned exponent = 127 - 18 + static_cast<unsigned>(random() % 38);
        inputs.push_back({glm::vec4(bits_to_float((exponent << 23) | (random() & 0x807fffffU)),
                                    bits_to_float((exponent << 23) | (random() & 0x807ff000U)), 0, 0)}); // ties
    }
    const ShaderProbe probe(part_text("math_half.glsl", {}), "result.xy = h(in0.xy);");
    const auto got = probe.run(inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        for (int k = 0; k < 2; ++k) {
            const auto wanted = static_cast<float>(to_half(static_cast<double>(inputs[i][0][k])));
            ASSERT_EQ(got[i][k], wanted) << inputs[i][0][k];
        }
    }
}

struct FunctionCase {
    std::string call; ///< of halves in0, in1, in2
    std::function<Triple(const Triple &, const Triple &, const Triple &)> twin;
};

Triple one(const Number &x) { return {x, Number{0}, Number{0}}; }

const FunctionCase functions[] = {
    {"result.rgb = h(in0.xyz + in1.xyz);", [](auto a, auto b, auto) { return a + b; }},
    {"result.rgb = h(in0.xyz * in1.xyz);", [](auto a, auto b, auto) { return a * b; }},
    {"result.rgb = h(in0.xyz / in1.x);", [](auto a, auto b, auto) { return a / b.x; }},
    {"result.x = h_dot(in0.xyz, in1.xyz);", [](auto a, auto b, auto) { return one(dot(a, b)); }},
    {"result.x = h_length(in0.xyz);", [](auto a, auto, auto) { return one(length(a)); }},
    {"result.rgb = h_normalize(in0.xyz);", [](auto a, auto, auto) { return normalize(a); }},
    {"result.rgb = h_cross(in0.xyz, in1.xyz);", [](auto a, auto b, auto) { return cross(a, b); }},
    {"result.rgb = h_reflect(in0.xyz, in1.xyz);", [](auto a, auto b, auto) { return reflect(a, b); }},
    {"result.x = h(inversesqrt(abs(in0.x)));",
     [](auto a, auto, auto) { return one(inversesqrt(Number{std::abs(a.x.value)})); }},
    {"result.x = h(exp(in0.x));", [](auto a, auto, auto) { return one(exp(a.x)); }},
    {"result.x = h(log(abs(in0.x)));", [](auto a, auto, auto) { return one(log(Number{std::abs(a.x.value)})); }},
    {"result.x = h_mod(in0.x, 2.0);", [](auto a, auto, auto) { return one(mod(a.x, Number{2})); }},
    {"result.x = h_smoothstep(-0.5, 0.75, in0.x);",
     [](auto a, auto, auto) { return one(smoothstep(Number{-0.5}, Number{0.75}, a.x)); }},
};

std::vector<ProbeInput> half_inputs() {
    Vectors random(7);
    std::vector<ProbeInput> inputs;
    const auto halves = [&](float scale) {
        const glm::vec3 v = scale * random.in_cube();
        const auto half = [](float x) { return static_cast<float>(to_half(static_cast<double>(x))); };
        return glm::vec4(half(v.x), half(v.y), half(v.z), 0);
    };
    for (int i = 0; i < 6000; ++i) {
        const float scales[] = {1, 1, 8, 300}; // 300: squares that overflow
        inputs.push_back({halves(scales[i % 4]), halves(1), halves(1)});
    }
    return inputs;
}

Triple triple(const glm::vec4 &v) {
    return {Number{static_cast<double>(v.x)}, Number{static_cast<double>(v.y)}, Number{static_cast<double>(v.z)}};
}

TEST_F(HalfProbes, FunctionsAreWithinOneUnitInTheLastPlace) {
    const std::vector<ProbeInput> inputs = half_inputs();
    for (const FunctionCase &function : functions) {
        const ShaderProbe probe(part_text("math_half.glsl", {}), function.call);
        const auto got = probe.run(inputs);
        double worst = 0;
        std::size_t differing = 0;
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const glm::dvec3 wanted =
                value_of(function.twin(triple(inputs[i][0]), triple(inputs[i][1]), triple(inputs[i][2])));
            for (int k = 0; k < (function.call.starts_with("result.rgb") ? 3 : 1); ++k) {
                const double by = ulps(static_cast<double>(got[i][k]), wanted[k]);
                worst = std::max(worst, by);
                differing += by > 0 ? 1 : 0;
            }
        }
        std::printf("| %-45s | %6zu of %zu differ | worst %g ulp\n", function.call.c_str(), differing, inputs.size(),
                    worst);
        EXPECT_LE(worst, 1) << function.call;
    }
}

/// pow() in two steps, each within one unit: together a rounding of log2 the other way costs n times as much.
TEST_F(HalfProbes, PowIsWithinOneUnitOfEachStep) {
    std::vector<ProbeInput> inputs;
    for (int i = 1; i <= 2048; ++i) {
        inputs.push_back({glm::vec4(static_cast<float>(i) / 2048, 0, 0, 0)});
    }
    const ShaderProbe probe(part_text("math_half.glsl", {}),
                            "result.x = h(log2(in0.x)); result.y = h(exp2(-16.0 * in0.x)); "
                            "result.z = h_pow(in0.x, 32.0); result.w = h_pow(in0.x, 128.0);");
    const auto got = probe.run(inputs);
    double logarithms = 0, exponentials = 0, powers[2] = {0, 0};
    int differing[2] = {0, 0};
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const auto x = static_cast<double>(inputs[i][0].x);
        logarithms = std::max(logarithms, ulps(static_cast<double>(got[i].x), to_half(std::log2(x))));
        exponentials = std::max(exponentials, ulps(static_cast<double>(got[i].y), to_half(std::exp2(-16 * x))));
        for (int k = 0; k < 2; ++k) {
            const Number n{k == 0 ? 32.0 : 128.0};
            const double by = ulps(static_cast<double>(got[i][2 + k]), pow(Number{x}, n).value);
            powers[k] = std::max(powers[k], by);
            differing[k] += by > 0 ? 1 : 0;
        }
    }
    std::printf("log2 %g ulp, exp2 %g ulp, pow 32: %d differ, worst %g ulp, pow 128: %d, %g ulp\n", logarithms,
                exponentials, differing[0], powers[0], differing[1], powers[1]);
    EXPECT_LE(logarithms, 1);
    EXPECT_LE(exponentials, 1);
    EXPECT_LE(powers[0], 1);
    EXPECT_LE(powers[1], 1);
}

} // namespace
} // namespace sandbox
