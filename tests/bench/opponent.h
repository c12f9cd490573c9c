#pragma once

#include "image/image.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace sandbox {

/// A program that someone writes by hand for one scene: what our frames are measured against. Point lights, one
/// object, no transform. Needs a current OpenGL 3.3 context with its functions loaded.
class Opponent {
  public:
    enum class Writing {
        textbook, ///< uniform structs in a loop, every vector by normalize(), pow()
        plain,    ///< lights as uniforms; exponent, coefficients and material written in
        lean      ///< all that does not move written in, one inversesqrt a vector, f^n by squarings
    };
    enum class Shading { per_vertex, per_pixel, constant_colour };
    enum class Highlight { phong, blinn_phong }; ///< Phong: the textbook's alone
    enum class Pixels { light, bytes };          ///< RGBA32F and 32-bit depth, or RGBA8 and 24-bit depth

    struct Kind {
        Writing writing = Writing::textbook;
        Shading shading = Shading::per_pixel;
        Highlight highlight = Highlight::blinn_phong;
        Pixels pixels = Pixels::light;
    };

    Opponent(const Scene &scene, const Kind &kind, Size size);

    /// Clear, draw, glFinish.
    void frame() const;
    /// The last frame, bottom row first.
    [[nodiscard]] std::vector<float> read_rgba() const;
    /// The same as 8 bits RGB, top row first.
    [[nodiscard]] std::vector<unsigned char> read_bytes() const;

  private:
    void upload_mesh(const Scene &scene);
    void upload_uniforms(const Scene &scene) const;

    Size size_;
    unsigned program_ = 0, vertex_array_ = 0, framebuffer_ = 0;
    int indices_ = 0;
};

/// Three attenuated point lights (red, green, white) on a sphere of 64 rings and 128 segments, shininess 32.
Scene three_lights_on_a_sphere();
/// One white directional light on the same sphere.
Scene one_directional_light();

} // namespace sandbox
