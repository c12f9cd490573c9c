#include "reference/lighting.h"
#include "reference/surface.h"
#include "render/probe_vectors.h"
#include "render/shader_probe.h"
#include "tools/gl_test.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

/// Each GLSL function on a grid of inputs against its double twin: powers, highlights, surface, colours.
/// The inputs are floats; the twin gets the very same values, so that what differs is the function's own rounding.
namespace sandbox {
namespace {

class FormulaProbes : public GlTest {};

double stable_power(double x, double n) { return n == 0 ? 1 : std::exp(n * std::log1p(-x)); }

TEST_F(FormulaProbes, StablePower) {
    std::vector<ProbeInput> inputs;
    for (const float n : {0.5F, 1.0F, 16.0F, 511.5F, 512.0F, 5e3F, 1e5F, 1e7F}) {
        for (const float x : {0.0F, 1e-30F, 1e-7F, 0.1249999F, 0.125F, 0.1250001F, 0.5F, 0.999F}) {
            inputs.push_back({glm::vec4(x, n, 0, 0)});
        }
        for (int i = 0; i <= 400; ++i) {
            inputs.push_back({glm::vec4(std::pow(10.0F, -9 + 9 * static_cast<float>(i) / 400.5F), n, 0, 0)});
        }
    }
    const ShaderProbe probe(part_text("power_stable.glsl", {}), "result.x = stable_power(in0.x, in0.y);");
    const std::vector<glm::vec4> got = probe.run(inputs);
    // t = -n log(1 - x) carries a relative error of 4 units (series, product, exp's own argument); t exp(-t) <= 1/e.
    // Mesa's log2 on x >= 1/8 adds 1e-6 n where n is small.
    ProbeTable table("stable_power", 1e-6);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const double x = static_cast<double>(inputs[i][0].x);
        table.compare(static_cast<double>(got[i].x), stable_power(x, static_cast<double>(inputs[i][0].y)), inputs[i]);
    }
}

struct ExponentCase {
    Exponent kind;
    float n;
};
const ExponentCase exponents[] = {{Exponent::one, 1},         {Exponent::textbook, 2},   {Exponent::textbook, 32},
                                  {Exponent::textbook, 1023}, {Exponent::textbook, 1e5}, {Exponent::stable, 2},
                                  {Exponent::stable, 32},     {Exponent::stable, 1023},  {Exponent::stable, 1024},
                                  {Exponent::stable, 1e5},    {Exponent::stable, 1e7}};

Features highlight_features(Model model, Exponent kind) {
    Features features;
    features.technique.model = model;
    features.exponent = kind;
    features.lights[LightType::directional].count = 1;
    features.lights[LightType::directional].specular = true;
    features.lights[LightType::directional].opposite = true; // among the probes are those with L = -V
    return features;
}

void set_shininess(const GlProgram &program, float n) {
    if (program.has("shininess")) {
        program.set("shininess", n);
    }
}

/// The stable form measures the angle between its vectors; the textbook's cosine feels their lengths.
glm::dvec3 vector_of(const glm::vec4 &input, Exponent kind) {
    const glm::dvec3 v(input.x, input.y, input.z);
    if (kind == Exponent::stable) {
        return unit(v);
    }
    return v;
}

/// N, L, V as in0, in1, in2.
void probe_highlight(const std::string &name, Model model, const ExponentCase &c, const std::string &part,
                     const std::string &call) {
    const Features features = highlight_features(model, c.kind);
    std::string text = "uniform float shininess;\n";
    if (c.kind == Exponent::stable) {
        text += part_text("power_stable.glsl", features);
    }
    const ShaderProbe probe(text + part_text(part, features),
                            "vec3 N = in0.xyz; vec3 L = in1.xyz; vec3 V = in2.xyz;" + call);
    const std::vector<ProbeInput> inputs = highlight_vectors(4000, 11);
    const auto got = probe.run(inputs, [&](const GlProgram &program) { set_shininess(program, c.n); });
    const double n = static_cast<double>(c.n);
    ProbeTable table(name + " n = " + std::to_string(static_cast<long>(c.n)),
                     c.kind == Exponent::stable ? stable_bound(n) : textbook_bound(n));
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const glm::dvec3 N = vector_of(inputs[i][0], c.kind);
        const glm::dvec3 L = vector_of(inputs[i][1], c.kind);
        const glm::dvec3 V = vector_of(inputs[i][2], c.kind);
        const double h = glm::length(L + V);
        if (model == Model::phong) {
            table.compare(static_cast<double>(got[i].x), reference::power_of_dot(2 * glm::dot(N, L) * N - L, V, n),
                          inputs[i]);
        } else if (h > 0 && h < 1e-2) {
            table.undecided(); // L = -V but for rounding: H is what rounding leaves
        } else {
            const glm::dvec3 H = h > 0 ? (L + V) / h : N;
            // What rounding L + V leaves is the larger, the shorter H.
            table.compare(static_cast<double>(got[i].x), reference::power_of_dot(N, H, n), inputs[i],
                          h > 0 ? 1 + 0.5 / h : 1);
        }
    }
}

TEST_F(FormulaProbes, PhongWithEveryExponent) {
    for (const ExponentCase &c : exponents) {
        const std::string kind = c.kind == Exponent::one ? "one" : c.kind == Exponent::stable ? "stable" : "textbook";
        probe_highlight("phong, " + kind, Model::phong, c, "reflection_phong.glsl",
                        "result.x = phong(reflect(-V, N), L);");
    }
}

TEST_F(FormulaProbes, BlinnPhongWithEveryExponent) {
    for (const ExponentCase &c : exponents) {
        const std::string kind = c.kind == Exponent::one ? "one" : c.kind == Exponent::stable ? "stable" : "textbook";
        probe_highlight("blinn_phong, " + kind, Model::blinn_phong, c, "reflection_blinn_phong.glsl",
                        "result.x = blinn_phong(N, L + V);");
    }
}

TEST_F(FormulaProbes, CheckerColor) {
    Checker checker;
    checker.cells = 7;
    const double half = 1.3;
    const ShaderProbe probe(part_text("base_checker.glsl", {}), "result.rgb = checker_color(in0.xyz);");
    std::vector<ProbeInput> inputs;
    Vectors random(3);
    for (int i = 0; i < 4000; ++i) {
        glm::vec3 p = static_cast<float>(half) * random.in_cube();
        p[i % 3] = i % 5 == 0 ? std::copysign(static_cast<float>(half), p[i % 3]) : p[i % 3]; // faces of a box
        inputs.push_back({glm::vec4(p, 0)});
    }
    const auto got = probe.run(inputs, [&](const GlProgram &program) {
        program.set("checker_colors[0]", glm::vec3(checker.colors[0]));
        program.set("checker_colors[1]", glm::vec3(checker.colors[1]));
        program.set("checker_cells_per_unit", static_cast<float>(checker.cells / (2 * half)));
        const double below = checker.cells / 2.0;
        program.set("checker_whole", glm::vec3(static_cast<float>(std::round(below))));
        program.set("checker_rest", glm::vec3(static_cast<float>(below - std::round(below))));
        program.set("checker_last", static_cast<float>(checker.cells - 1));
    });
    ProbeTable table("checker_color", 1e-7); // a colour is one of two, rounded to float32
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const glm::dvec3 p{glm::vec3(inputs[i][0])};
        const glm::dvec3 cells = reference::checker_coordinates(checker, half, p);
        bool border = false; // within 4 units of float32 of a border between cells
        for (int axis = 0; axis < 3; ++axis) {
            const double nearest = std::round(cells[axis]);
            border = border || (nearest > 0 && nearest < checker.cells && std::abs(cells[axis] - nearest) < 4e-6);
        }
        if (border) {
            table.undecided();
            continue;
        }
        table.compare(got[i], reference::checker_color(checker, half, p), inputs[i]);
    }
}

TEST_F(FormulaProbes, SrgbCurve) {
    std::string text;
    for (const std::string &part : Assets("shaders").list("")) { // the one that holds it
        const std::string own = ShaderParts(Assets("shaders")).text(part);
        text = own.find("\nvec3 srgb_curve") != std::string::npos ? own : text;
    }
    const ShaderProbe probe(lines_between(text, "vec3 srgb_curve", "#endif"), "result.rgb = srgb_curve(in0.xyz);");
    std::vector<ProbeInput> inputs;
    for (int i = 0; i <= 3000; ++i) {
        const float x = static_cast<float>(i) / 3000;
        inputs.push_back({glm::vec4(x, x * x * 0.01F, 0.0031308F + (x - 0.5F) * 1e-5F, 0)});
    }
    const auto got = probe.run(inputs);
    const auto curve = [](double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; };
    // pow: 2e-6 at most on Mesa (log2 and exp2 by polynomials); the curve's two arms differ by 3e-8 where they meet.
    ProbeTable table("srgb_curve", 2e-6);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const glm::dvec3 x{glm::vec3(inputs[i][0])};
        table.compare(got[i], {curve(x.x), curve(x.y), curve(x.z)}, inputs[i]);
    }
}

} // namespace
} // namespace sandbox
