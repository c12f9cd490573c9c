#include "image/image_file.h"

#include "image/error.h"
#include "image/jpeg.h"

namespace sandbox {

Image decode_image(std::string_view bytes, std::string_view name) {
    if (bytes.starts_with(png_signature)) {
        return decode_png(bytes, name);
    }
    if (bytes.starts_with(jpeg_signature)) {
        return decode_jpeg(bytes, name);
    }
    throw InputError("{}: expected a PNG or JPEG image, got {}", name,
                     bytes.empty() ? "an empty file" : "another kind of file");
}

} // namespace sandbox
