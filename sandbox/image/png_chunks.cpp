#include "image/png_chunks.h"

#include "image/error.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <zlib.h>

namespace sandbox {
namespace {

struct Chunk {
    std::string_view type, data; ///< `data` is cut where the file ends too early
};

/// The chunks of a file, in their order, up to its last one.
class Chunks {
  public:
    explicit Chunks(std::string_view bytes) : rest_(bytes.substr(std::min(png_signature.size(), bytes.size()))) {}

    std::optional<Chunk> next() {
        if (rest_.size() < 8) {
            return std::nullopt;
        }
        std::size_t length = 0;
        for (const char byte : rest_.substr(0, 4)) {
            length = length << 8 | static_cast<unsigned char>(byte);
        }
        const Chunk chunk{rest_.substr(4, 4), rest_.substr(8, length)};
        rest_.remove_prefix(chunk.type == "IEND" ? rest_.size() : std::min(length + 12, rest_.size()));
        return chunk;
    }

  private:
    std::string_view rest_;
};

} // namespace

bool has_png_chunk(std::string_view bytes, std::string_view type) {
    Chunks chunks(bytes);
    while (const auto chunk = chunks.next()) {
        if (chunk->type == type || chunk->type == "IDAT") {
            return chunk->type == type;
        }
    }
    return false;
}

bool png_data_is_split(std::string_view bytes) {
    Chunks chunks(bytes);
    bool began = false;
    bool ended = false;
    while (const auto chunk = chunks.next()) {
        const bool data = chunk->type == "IDAT";
        if (data && ended) {
            return true;
        }
        began = began || data;
        ended = began && !data;
    }
    return false;
}

void check_png_data(std::string_view bytes, std::size_t most, std::string_view name) {
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) {
        throw std::bad_alloc();
    }
    const std::unique_ptr<z_stream, decltype(&inflateEnd)> end(&stream, inflateEnd);
    int state = Z_OK;
    std::size_t inflated = 0;
    Chunks chunks(bytes);
    while (const auto chunk = chunks.next()) {
        if (chunk->type != "IDAT") {
            continue;
        }
        static_assert(std::numeric_limits<uInt>::max() >= 0x7FFFFFFF); // what a chunk's length may be
        stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(chunk->data.data())); // only read
        stream.avail_in = static_cast<uInt>(chunk->data.size());
        while (state == Z_OK) {
            unsigned char out[65536];
            stream.next_out = out;
            stream.avail_out = sizeof out;
            state = inflate(&stream, Z_NO_FLUSH);
            inflated += sizeof out - stream.avail_out;
            if (inflated > most) {
                throw InputError("{}: the PNG file holds more data than its pixels need", name);
            }
        }
        state = state == Z_BUF_ERROR ? Z_OK : state; // all of this chunk is read
    }
    if (state != Z_STREAM_END) {
        throw InputError("{}: the end of the PNG file's pixel data is damaged ({})", name,
                         stream.msg != nullptr ? stream.msg : "its checksum is missing");
    }
}

} // namespace sandbox
