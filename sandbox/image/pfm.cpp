#include "image/pfm.h"

#include "image/error.h"
#include "image/number.h"

#include <bit>
#include <charconv>
#include <cmath>

namespace sandbox {
namespace {

[[noreturn]] void refuse(std::string_view name, std::string_view why) {
    throw InputError("{}: cannot decode the PFM file ({})", name, why);
}

void append_float(std::string &out, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int shift = 0; shift < 32; shift += 8) {
        out.push_back(static_cast<char>(bits >> shift & 0xffU));
    }
}

float float_at(std::string_view bytes, std::size_t at, bool little_endian) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t from = little_endian ? 3 - i : i;
        bits = bits << 8 | static_cast<unsigned char>(bytes[at + from]);
    }
    return std::bit_cast<float>(bits);
}

/// The next word of the header; exactly one white space ends it.
std::string_view take_word(std::string_view &rest) {
    const std::size_t end = rest.find_first_of(" \t\r\n");
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    return word;
}

std::from_chars_result read(const char *first, const char *last, int &value) {
    return std::from_chars(first, last, value);
}
std::from_chars_result read(const char *first, const char *last, double &value) {
    return read_number(first, last, value);
}

template <class T> bool parse(std::string_view word, T &value) {
    const auto [end, error] = read(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
}

} // namespace

std::string encode_pfm(const Image &image) {
    std::string out = fmt::format("PF\n{} {}\n-1.0\n", image.size.width, image.size.height);
    out.reserve(out.size() + image.pixels.size() * 12);
    for (int y = image.size.height - 1; y >= 0; --y) {
        for (int x = 0; x < image.size.width; ++x) {
            for (int channel = 0; channel < 3; ++channel) {
                append_float(out, image.at(x, y)[channel]);
            }
        }
    }
    return out;
}

Image decode_pfm(std::string_view bytes, std::string_view name) {
    std::string_view rest = bytes;
    const std::string_view kind = take_word(rest);
    if (kind != "PF" && kind != "Pf") {
        refuse(name, "expected it to begin with PF or Pf");
    }
    const std::size_t channels = kind == "PF" ? 3 : 1;
    Size size;
    double scale = 0;
    const bool numbers =
        parse(take_word(rest), size.width) && parse(take_word(rest), size.height) && parse(take_word(rest), scale);
    if (!numbers || size.width < 1 || size.height < 1 || !std::isfinite(scale) || scale == 0) {
        refuse(name, "expected width, height and a scale other than 0");
    }
    // Compared by division: the product of two hostile sizes may not fit.
    const std::size_t row = static_cast<std::size_t>(size.width) * channels * 4;
    if (rest.size() % row != 0 || rest.size() / row != static_cast<std::size_t>(size.height)) {
        refuse(name, "its length does not match its width and height");
    }
    Image image(size);
    std::size_t at = 0;
    for (int y = size.height - 1; y >= 0; --y) {
        for (int x = 0; x < size.width; ++x, at += channels * 4) {
            for (int channel = 0; channel < 3; ++channel) {
                const std::size_t offset = channels == 3 ? static_cast<std::size_t>(channel) * 4 : 0;
                image.at(x, y)[channel] = float_at(rest, at + offset, scale < 0);
            }
        }
    }
    return image;
}

} // namespace sandbox
