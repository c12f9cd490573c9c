#pragma once

#include "render/gl_object.h"
#include "shading/program_source.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

namespace sandbox {

/// A program did not compile or link; the message's lines read `reflection_phong.glsl:31: ...`.
struct ShaderError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A linked program and the locations of its active uniforms.
class GlProgram {
  public:
    /// Throws ShaderError, or DeviceLimitError where the device has too little room for the uniforms.
    explicit GlProgram(const ProgramSource &source);

    [[nodiscard]] unsigned id() const { return program_.id(); }
    /// Names of all active uniforms: "point_lights[0].position".
    [[nodiscard]] const std::map<std::string, int, std::less<>> &uniforms() const { return uniforms_; }
    [[nodiscard]] bool has(std::string_view name) const { return uniforms_.contains(name); }

    // The program must be in use. A uniform that is not active is a programming error: it throws std::logic_error.
    void set(std::string_view name, int value) const;
    void set(std::string_view name, unsigned value) const;
    void set(std::string_view name, float value) const;
    void set(std::string_view name, const glm::vec3 &value) const;
    void set(std::string_view name, const glm::mat3 &value) const;
    void set(std::string_view name, const glm::mat4 &value) const;

  private:
    [[nodiscard]] int location(std::string_view name) const;

    ProgramObject program_;
    std::map<std::string, int, std::less<>> uniforms_;
};

/// Throws ShaderError where a stage is no GLSL ES 3.00, so that it would fail in a browser. Only drivers that offer
/// ARB_ES3_compatibility can tell; others accept everything here.
void require_es(const ProgramSource &source);

} // namespace sandbox
