#include "image/glyphs.h"

#include <array>

namespace sandbox {
namespace {

constexpr std::array<std::string_view, 95> strokes{
    "",                               // space
    "1i18 14",                        // !
    "1i1e 4i4e",                      // "
    "3i14 7i54 1d9d 0888",            // #
    "~8f8i0i0b8b840407 4j43",         // $
    "8i04 ~0i3i3d0d0i ~5989845459",   // %
    "~941d1i6i6d0a04749a",            // &
    "1i1e",                           // '
    "~3j0g0532",                      // (
    "~0j3g3502",                      // )
    "3h3b 0g6c 6g0c",                 // *
    "4d45 0989",                      // +
    "2501",                           // ,
    "0959",                           // -
    "14",                             // .
    "026j",                           // /
    "~0i8i84040i",                    // 0
    "1f4i44 1474",                    // 1
    "~0f0i8i8c04 0484",               // 2
    "~0f0i8i8b3b ~3b8b840407",        // 3
    "6i0888 6i64",                    // 4
    "7i1i0b ~0b2d8d840407",           // 5
    "~8f8i0i08 ~0c8c84040c",          // 6
    "0i8i24",                         // 7
    "~1i7i7b1b1i ~0b8b84040b",        // 8
    "~0a8a8i0i0a ~8e840407",          // 9
    "1c 14",                          // :
    "2c 2501",                        // ;
    "8d0985",                         // <
    "0b8b 0787",                      // =
    "0d8905",                         // >
    "~0f0i8i8b4b48 44",               // ?
    "~3c7c77373c 7c77 ~77a6ai0i0484", // @
    "045ia4 2888",                    // A
    "040i ~0i4i8i8b4b0b ~0b5b9b945404",
    "~9f9i0i049497",
    "040i ~0i4i9i944404",
    "8i0i0484 0b6b",
    "8i0i04 0b6b",
    "~9f9i0i04949a 9a5a",
    "0i04 9i94 0b9b",
    "0i4i 2i24 0444",
    "6i68 ~68640408",
    "0i04 8i09 3c94",
    "0i0484",
    "040i69cic4",
    "040i949i",
    "~0iaia4040i",
    "040i ~0i4i8i8a4a0a",
    "~0iaia4040i 67a3",
    "040i ~0i4i8i8a4a0a 4a84",
    "~8f8i0i0b8b840407",
    "0iai 5i54",
    "0i09 ~09049499 999i",
    "0i54ai",
    "0i447ea4ei",
    "0i94 9i04",
    "0i5bai 5b54",
    "0i9i0494",         // Z
    "3j0j0232",         // [
    "0j62",             // backslash
    "0j3j3202",         // ]
    "0e3i6e",           // ^
    "0282",             // _
    "0i2f",             // `
    "7e74 ~0e7e74040e", // a
    "0i04 ~0e7e74040e",
    "~7c7e0e047476",
    "7i74 ~0e7e74040e",
    "0979 ~797e0e047476",
    "~5i2i2d 2d24 0e5e",
    "7e73 ~73700002 ~0e7e74040e",
    "0i04 ~0a0e7e7a 7a74",
    "1e14 1i",
    "3e33 ~333000 3i",
    "0i04 6e08 2a74",
    "0i07 ~070434",
    "0e04 ~0a0e6e6a 6a64 ~6a6ececa cac4",
    "0e04 ~0a0e7e7a 7a74",
    "~0e8e84040e",
    "0e00 ~0e7e74040e",
    "7e70 ~0e7e74040e",
    "0e04 ~0a0e5e",
    "~7c7e0e0979740406",
    "2h27 ~272454 0e5e",
    "0e08 ~08047478 7e74",
    "0e448e",
    "0e346e94ce",
    "0e74 7e04",
    "0e34 8e10",
    "0e7e0474",            // z
    "~4j2j2b0b ~0b2b2242", // {
    "1j12",                // |
    "~0j2j2b4b ~4b2b2202", // }
    "~082c668a",           // ~
};

} // namespace

std::string_view glyph_strokes(char character) {
    const bool known = character >= ' ' && character <= '~';
    return strokes[static_cast<std::size_t>((known ? character : '?') - ' ')];
}

} // namespace sandbox
