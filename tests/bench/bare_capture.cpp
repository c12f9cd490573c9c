#include "bare_context.h"
#include "opponent.h"

#include <cstdio>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_image_write.h>
#pragma GCC diagnostic pop

/// The least program that draws a picture and writes a PNG: EGL without a surface, the textbook program, stb.
int main(int argc, char **argv) {
    using namespace sandbox;
    if (argc != 2) {
        std::fprintf(stderr, "usage: bare_capture FILE.png\n");
        return 2;
    }
    make_bare_context();
    constexpr Size size{1280, 720};
    const Opponent textbook(three_lights_on_a_sphere(), {}, size);
    textbook.frame();
    const auto bytes = textbook.read_bytes();
    return stbi_write_png(argv[1], size.width, size.height, 3, bytes.data(), 3 * size.width) != 0 ? 0 : 2;
}
