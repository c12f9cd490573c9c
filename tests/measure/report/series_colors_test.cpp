#include "image/file_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <regex>
#include <string>
#include <vector>

namespace sandbox {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple times(const Matrix &m, const Triple &v) {
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    }
    return result;
}

/// What linear RGB becomes for normal, red-blind and green-blind eyes (Machado, Oliveira, Fernandes 2009, severity 1).
constexpr std::array<Matrix, 3> eyes{{
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
}};

Triple linear(unsigned hex) {
    Triple rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double c = ((hex >> (16 - 8 * i)) & 0xFFU) / 255.0;
        rgb[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    }
    return rgb;
}

/// CIELAB of linear sRGB, white D65.
Triple lab(Triple rgb) {
    std::ranges::transform(rgb, rgb.begin(), [](double c) { return std::clamp(c, 0.0, 1.0); });
    const Matrix to_xyz{{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
    const Triple xyz = times(to_xyz, rgb);
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const double x = f(xyz[0] / 0.9505), y = f(xyz[1]), z = f(xyz[2] / 1.089);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// The series colours of a page or the window, six for each theme.
std::vector<unsigned> colors_in(const std::string &file, const std::string &pattern) {
    const std::string text = read_file(std::string(SOURCE_DIR) + file);
    const std::regex color(pattern);
    std::vector<unsigned> found;
    for (std::sregex_iterator at(text.begin(), text.end(), color), end; at != end; ++at) {
        found.push_back(static_cast<unsigned>(std::stoul((*at)[1], nullptr, 16)));
    }
    return found;
}

/// 20 is about ten times what can just be seen side by side: enough for thin lines and small markers.
TEST(SeriesColors, KeepApartForColorBlindEyes) {
    const std::vector<unsigned> all = colors_in("/assets/page/style.css", "--s[0-5]: #([0-9a-f]{6})");
    ASSERT_EQ(all.size(), 18U) << "light, dark, and for printing";
    for (std::size_t theme = 0; theme < 18; theme += 6) {
        for (std::size_t eye = 0; eye < eyes.size(); ++eye) {
            for (std::size_t i = theme; i < theme + 6; ++i) {
                for (std::size_t j = theme; j < i; ++j) {
                    const Triple a = lab(times(eyes[eye], linear(all[i]))), b = lab(times(eyes[eye], linear(all[j])));
                    EXPECT_GT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 20)
                        << "series " << i - theme << " and " << j - theme << ", eye " << eye;
                }
            }
        }
    }
}

TEST(SeriesColors, OfTheWindowAreTheReports) {
    const std::vector<unsigned> page = colors_in("/assets/page/style.css", "--s[0-5]: #([0-9a-f]{6})");
    const std::string text = read_file(std::string(SOURCE_DIR) + "/sandbox/ui/widgets/theme.cpp");
    for (std::size_t i = 0; i < page.size(); ++i) {
        char hex[16];
        std::snprintf(hex, sizeof hex, "0x%06X", page[i]);
        EXPECT_NE(text.find(hex), std::string::npos) << hex;
    }
}

} // namespace
} // namespace sandbox
