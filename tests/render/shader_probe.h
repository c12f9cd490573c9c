#pragma once

#include "render/gl_program.h"
#include "shading/template_values.h"

#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

namespace sandbox {

/// Up to eight vec4 that a probe reads as in0 ... in7.
using ProbeInput = std::array<glm::vec4, 8>;

/// Runs GLSL functions for many inputs, a pixel each, on whatever OpenGL there is. Needs a current Context.
class ShaderProbe {
  public:
    /// `declarations` are the parts' own text; `body` holds statements that read in0 ... in7 and set `result`.
    ShaderProbe(const std::string &declarations, const std::string &body);

    /// One result for each input. `set_uniforms` is called with the program in use.
    std::vector<glm::vec4> run(const std::vector<ProbeInput> &inputs,
                               const std::function<void(const GlProgram &)> &set_uniforms = {}) const;

  private:
    GlProgram program_;
    VertexArray empty_;
};

/// A part's text as these features' stage holds it, after the choices that it reads.
std::string part_text(const std::string &part, const Features &program, Stage stage = Stage::fragment);
/// The lines of `text` between the first that begins with `from` and the next that begins with `to`.
std::string lines_between(const std::string &text, const std::string &from, const std::string &to);

/// What a probe found: the figures of one line of the table, and the check against its bound.
class ProbeTable {
  public:
    /// `bound` is of |got - wanted| / max(1, |wanted|).
    ProbeTable(std::string name, double bound);
    /// Prints the line; fails the test if the bound was not met, or nothing was compared.
    ~ProbeTable();
    ProbeTable(const ProbeTable &) = delete;
    ProbeTable &operator=(const ProbeTable &) = delete;

    /// `allowance`: how often the bound the input's own conditioning is worth.
    void compare(double got, double wanted, const ProbeInput &where, double allowance = 1);
    void compare(const glm::vec4 &got, const glm::dvec3 &wanted, const ProbeInput &where, double allowance = 1);
    /// An input where rounding alone decides a branch: counted, not compared.
    void undecided() { ++undecided_; }

  private:
    std::string name_;
    double bound_;
    double absolute_ = 0, relative_ = 0, scaled_ = 0;
    ProbeInput worst_{};
    double worst_got_ = 0, worst_wanted_ = 0;
    std::size_t compared_ = 0, undecided_ = 0;
};

} // namespace sandbox
