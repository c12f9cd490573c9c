#include "render/shader_probe.h"

#include "render/target.h"
#include "shading/template.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <limits>
#include <sstream>

namespace sandbox {
namespace {

constexpr int columns = 256;
constexpr int texels = static_cast<int>(ProbeInput{}.size());

ProgramSource probe_source(const std::string &declarations, const std::string &body) {
    const ShaderParts parts(Assets("shaders"));
    std::string text =
        "#version 330 core\nlayout(location = 0) out vec4 probe_result;\nuniform sampler2D probe_inputs;\n" +
        declarations + "\nvoid main()\n{\n";
    for (int i = 0; i < texels; ++i) {
        const std::string k = std::to_string(i);
        text += "    vec4 in" + k + " = texelFetch(probe_inputs, ivec2(gl_FragCoord.xy) * ivec2(" +
                std::to_string(texels) + ", 1) + ivec2(" + k + ", 0), 0);\n";
    }
    text += "    vec4 result = vec4(0.0);\n" + body + "\n    probe_result = result;\n}\n";
    StageSource fragment{text, {}};
    for (int line = 1; line <= std::count(text.begin(), text.end(), '\n') + 1; ++line) {
        fragment.origins.push_back({"probe", line});
    }
    return {expand(parts, "display_vertex.glsl", {}), fragment};
}

Texture input_texture(const std::vector<ProbeInput> &inputs, int rows) {
    std::vector<ProbeInput> padded = inputs;
    padded.resize(static_cast<std::size_t>(rows) * columns, inputs.front());
    Texture texture = make_texture();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, columns * texels, rows, 0, GL_RGBA, GL_FLOAT, padded.data());
    return texture;
}

std::string describe(const ProbeInput &input) {
    std::ostringstream text;
    text.precision(9);
    for (const glm::vec4 &v : input) {
        text << " (" << v.x << ' ' << v.y << ' ' << v.z << ' ' << v.w << ')';
    }
    return text.str();
}

} // namespace

ShaderProbe::ShaderProbe(const std::string &declarations, const std::string &body)
    : program_(probe_source(declarations, body)), empty_(make_vertex_array()) {}

std::vector<glm::vec4> ShaderProbe::run(const std::vector<ProbeInput> &inputs,
                                        const std::function<void(const GlProgram &)> &set_uniforms) const {
    const int rows = (static_cast<int>(inputs.size()) + columns - 1) / columns;
    const Target target({columns, rows});
    const Texture texture = input_texture(inputs, rows); // stays bound
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    glViewport(0, 0, columns, rows);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glUseProgram(program_.id());
    program_.set("probe_inputs", 0);
    if (set_uniforms) {
        set_uniforms(program_);
    }
    glBindVertexArray(empty_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    const Image image = target.read_color();
    std::vector<glm::vec4> results;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const int index = static_cast<int>(i);
        results.push_back(image.at(index % columns, rows - 1 - index / columns));
    }
    return results;
}

std::string part_text(const std::string &part, const Features &program, Stage stage) {
    const TemplateValues values = template_values(program, derive_needs(program), stage);
    const std::string text = expand(ShaderParts(Assets("shaders")), part, values).text;
    std::string declarations;
    for (const std::string &choice : values.choices) {
        if (const std::string name = uniform_name(choice); text.find(name) != std::string::npos) {
            declarations += "uniform bool " + name + ";\n";
        }
    }
    return declarations + text;
}

std::string lines_between(const std::string &text, const std::string &from, const std::string &to) {
    const std::size_t begin = text.find("\n" + from);
    const std::size_t end = text.find("\n" + to, begin + 1);
    if (begin == std::string::npos || end == std::string::npos) {
        throw std::logic_error("no lines from '" + from + "' to '" + to + "'");
    }
    return text.substr(begin + 1, end - begin);
}

ProbeTable::ProbeTable(std::string name, double bound) : name_(std::move(name)), bound_(bound) {
    static bool begun = false;
    if (!begun) {
        std::printf("| %-46s | %7s | %6s | %9s | %9s | %9s | where, if close to the bound\n", "function", "values",
                    "undec.", "absolute", "relative", "bound");
        begun = true;
    }
}

ProbeTable::~ProbeTable() {
    std::printf("| %-46s | %7zu | %6zu | %9.2e | %9.2e | %9.2e |%s\n", name_.c_str(), compared_, undecided_, absolute_,
                relative_, bound_, scaled_ > 0.5 * bound_ ? describe(worst_).c_str() : "");
    EXPECT_GT(compared_, undecided_) << name_;
    EXPECT_LE(scaled_, bound_) << name_ << ": got " << worst_got_ << ", not " << worst_wanted_ << " at"
                               << describe(worst_);
}

void ProbeTable::compare(double got, double wanted, const ProbeInput &where, double allowance) {
    const double difference = std::abs(got - wanted);
    const double error = std::isfinite(difference) ? difference : std::numeric_limits<double>::infinity();
    ++compared_;
    absolute_ = std::max(absolute_, error);
    // Below a level that no display and no sum shows, a relative error says nothing.
    relative_ = std::max(relative_, std::abs(wanted) > 1e-6 ? error / std::abs(wanted) : 0);
    const double scaled = error / std::max(1.0, std::abs(wanted)) / allowance;
    if (scaled > scaled_) {
        scaled_ = scaled;
        worst_ = where;
        worst_got_ = got;
        worst_wanted_ = wanted;
    }
}

void ProbeTable::compare(const glm::vec4 &got, const glm::dvec3 &wanted, const ProbeInput &where, double allowance) {
    for (int channel = 0; channel < 3; ++channel) {
        compare(static_cast<double>(got[channel]), wanted[channel], where, allowance);
    }
}

} // namespace sandbox
