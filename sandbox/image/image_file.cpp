#include "image/image_file.h"

#include "image/codecs.h"
#include "image/error.h"

namespace sandbox {

Image decode_image(std::string_view bytes, std::string_view name) {
    if (bytes.starts_with(png_signature)) {
        return decode_png(bytes, name);
    }
    if (bytes.starts_with(jpeg_signature)) {
        return decode_jpeg(bytes, name);
    }
    throw InputError(std::string(name) + ": expected a PNG or JPEG image, got " +
                     (bytes.empty() ? "an empty file" : "another kind of file"));
}

Image from_bytes(Size size, const unsigned char *bytes, int channels) {
    Image image(size);
    for (glm::vec4 &pixel : image.pixels) {
        for (int channel = 0; channel < channels; ++channel) {
            pixel[channel] = static_cast<float>(*bytes++) / 255.0F;
        }
    }
    return image;
}

} // namespace sandbox
