#include "measure/report/text.h"

#include <cmath>
#include <cstdio>

namespace sandbox {
namespace {

std::string printed(const char *format, double value) {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

} // namespace

std::string short_number(double value) {
    if (!std::isfinite(value)) {
        return "not finite";
    }
    if (value == 0) {
        return "0";
    }
    const double size = std::abs(value);
    if (size < 1e-3 || size >= 1e5) {
        return printed("%.2e", value);
    }
    const int decimals = size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : size >= 0.1 ? 3 : size >= 0.01 ? 4 : 5;
    char text[48];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::string milliseconds_text(double value) {
    return printed(value >= 100 ? "%.0f" : value >= 10 ? "%.1f" : value >= 1 ? "%.2f" : "%.3f", value);
}

std::string mesh_words(const PlannedMesh &mesh) {
    if (!mesh.ladder) {
        return "the scene's own mesh";
    }
    return std::to_string(mesh.rings) + " rings" + (mesh.own ? " (the scene's own)" : "");
}

std::string bound_name(double bound) { return bound == 1e-5 ? "1e-5" : "1/" + std::to_string(std::lround(1 / bound)); }

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '"':
            out += "&quot;";
            break;
        default:
            out += c;
        }
    }
    return out;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        unsigned triple = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            triple = triple << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            out += k <= count ? digits[triple >> (18 - 6 * k) & 63U] : '=';
        }
    }
    return out;
}

} // namespace sandbox
