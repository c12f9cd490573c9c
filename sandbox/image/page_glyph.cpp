#include "image/page_glyph.h"

#include <cstdlib>

// sandbox/page/glyphs.js
extern "C" {
double page_glyph_advance(unsigned character, double height);
unsigned char *page_glyph(unsigned character, double height, int *box);
}

namespace sandbox {

GlyphPicture page_glyph(char32_t character, double height) {
    int box[4] = {};
    const std::unique_ptr<unsigned char, decltype(&std::free)> cover(
        ::page_glyph(static_cast<unsigned>(character), height, box), &std::free);
    GlyphPicture picture{box[2], box[3], static_cast<double>(box[0]), static_cast<double>(box[1]), {}};
    picture.cover.assign(cover.get(), cover.get() + picture.width * picture.height);
    return picture;
}

double page_glyph_advance(char32_t character, double height) {
    return ::page_glyph_advance(static_cast<unsigned>(character), height);
}

} // namespace sandbox
