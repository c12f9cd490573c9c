#pragma once

#include "image/image.h"
#include "scene/scene.h"

namespace sandbox {

/// A program as a textbook writes it by hand: world space in float32, every vector by normalize(), H = normalize(L +
/// V), pow(), an array of light structs in a loop. What our frames are measured against. Point lights, one object, no
/// transform. Needs a current OpenGL 3.3 context with its functions loaded.
class Textbook {
  public:
    enum class Shading { per_vertex, per_pixel, constant_colour };
    enum class Highlight { phong, blinn_phong };

    Textbook(const Scene &scene, Shading shading, Highlight highlight, Size size);

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
