#include "fuzz/png_mutator.h"

#include "image/png.h"

#include <algorithm>
#include <array>
#include <random>
#include <utility>
#include <vector>
#include <zlib.h>

namespace sandbox {
namespace {

using Dice = std::minstd_rand;
std::size_t roll(Dice &dice, std::size_t sides) { return static_cast<std::size_t>(dice()) / 7 % sides; }

struct Chunk {
    std::string type, data;
};

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (const char c : bytes.substr(0, 4)) {
        value = value << 8 | static_cast<unsigned char>(c);
    }
    return value;
}
std::string four_bytes(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes += static_cast<char>(value >> shift & 0xffU);
    }
    return bytes;
}

const Bytef *zbytes(const std::string &text) { return reinterpret_cast<const Bytef *>(text.data()); }

std::vector<Chunk> chunks_of(std::string_view bytes) {
    std::vector<Chunk> chunks;
    for (bytes.remove_prefix(png_signature.size()); bytes.size() >= 12;) {
        const std::size_t length = std::min<std::size_t>(big_endian(bytes), bytes.size() - 12);
        chunks.push_back({std::string(bytes.substr(4, 4)), std::string(bytes.substr(8, length))});
        bytes.remove_prefix(length + 12);
    }
    return chunks;
}

std::string file_of(const std::vector<Chunk> &chunks) {
    std::string bytes(png_signature);
    for (const Chunk &chunk : chunks) {
        const std::string body = chunk.type + chunk.data;
        bytes += four_bytes(static_cast<std::uint32_t>(chunk.data.size())) + body +
                 four_bytes(static_cast<std::uint32_t>(crc32(0, zbytes(body), static_cast<uInt>(body.size()))));
    }
    return bytes;
}

void mutate_data(std::string &data, std::size_t growth, MutateBytes mutate) {
    const std::size_t size = data.size();
    data.resize(size + growth);
    data.resize(mutate(reinterpret_cast<std::uint8_t *>(data.data()), size, data.size()));
}

/// The rows of all IDAT chunks, changed, in one chunk in the place of the first.
void mutate_pixels(std::vector<Chunk> &chunks, MutateBytes mutate) {
    std::string packed;
    for (const Chunk &chunk : chunks) {
        packed += chunk.type == "IDAT" ? chunk.data : "";
    }
    constexpr uLongf most_rows = 65536;
    std::string rows(most_rows, '\0');
    uLongf length = most_rows;
    uncompress(reinterpret_cast<Bytef *>(rows.data()), &length, zbytes(packed), static_cast<uLong>(packed.size()));
    rows.resize(std::min(length, most_rows));
    mutate_data(rows, 16, mutate);
    uLongf size = compressBound(static_cast<uLong>(rows.size()));
    std::string again(size, '\0');
    compress2(reinterpret_cast<Bytef *>(again.data()), &size, zbytes(rows), static_cast<uLong>(rows.size()), 1);
    again.resize(size);
    bool first = true;
    std::erase_if(chunks, [&](const Chunk &chunk) { return chunk.type == "IDAT" && !std::exchange(first, false); });
    for (Chunk &chunk : chunks) {
        chunk.data = chunk.type == "IDAT" ? again : chunk.data;
    }
}

} // namespace

std::optional<std::string> changed_png(std::string_view bytes, unsigned seed, std::size_t most, MutateBytes mutate) {
    if (!bytes.starts_with(png_signature)) {
        return std::nullopt;
    }
    Dice dice(seed);
    std::vector<Chunk> chunks = chunks_of(bytes);
    if (chunks.empty()) {
        return std::nullopt;
    }
    constexpr std::array types{"IHDR", "PLTE", "IDAT", "IEND", "tRNS", "gAMA", "cHRM", "sRGB", "iCCP", "sBIT", "bKGD",
                               "hIST", "pHYs", "sPLT", "tIME", "tEXt", "zTXt", "iTXt", "eXIf", "CgBI", "acTL", "abCd"};
    const std::size_t at = roll(dice, chunks.size());
    Chunk &chunk = chunks[at];
    switch (roll(dice, 8)) {
    case 0: // the header: small sizes, all depths, all kinds of colour
        if (chunks[0].data.size() == 13) {
            constexpr std::array depths{1, 2, 4, 8, 16, 0, 32};
            chunks[0].data[3] = static_cast<char>(roll(dice, 9));
            chunks[0].data[7] = static_cast<char>(roll(dice, 9));
            chunks[0].data[8] = static_cast<char>(depths[roll(dice, depths.size())]);
            chunks[0].data[9] = static_cast<char>(roll(dice, 8));
            chunks[0].data[12] = static_cast<char>(roll(dice, 2));
        }
        break;
    case 1:
    case 2:
        mutate_pixels(chunks, mutate);
        break;
    case 3:
        chunk.type = types[roll(dice, types.size())];
        break;
    case 4:
        chunks.erase(chunks.begin() + static_cast<std::ptrdiff_t>(at));
        break;
    case 5: {
        Chunk copy = chunk;
        chunks.insert(chunks.begin() + static_cast<std::ptrdiff_t>(roll(dice, chunks.size() + 1)), std::move(copy));
        break;
    }
    case 6:
        std::swap(chunk, chunks[roll(dice, chunks.size())]);
        break;
    default:
        mutate_data(chunk.data, 32, mutate);
    }
    std::string made = file_of(chunks);
    return made.size() > most ? std::nullopt : std::optional(std::move(made));
}

} // namespace sandbox
