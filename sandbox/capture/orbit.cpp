#include "capture/orbit.h"

#include "image/error.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace sandbox {
namespace {

/// Rodrigues' rotation of `v` about the unit `axis`, right-handed.
glm::dvec3 rotate_about(glm::dvec3 v, glm::dvec3 axis, double radians) {
    const double c = std::cos(radians);
    return v * c + glm::cross(axis, v) * std::sin(radians) + axis * (glm::dot(axis, v) * (1 - c));
}

/// Length of the conversion "%d" or "%0Nd" that `text` begins with; 0 if it begins with none.
std::size_t conversion_length(std::string_view text) {
    if (text.starts_with("%d")) {
        return 2;
    }
    const bool padded =
        text.size() >= 4 && text.starts_with("%0") && text[2] >= '1' && text[2] <= '9' && text[3] == 'd';
    return padded ? 4 : 0;
}

std::string padded_number(int number, std::string_view conversion) {
    std::string digits = std::to_string(number);
    const std::size_t width = conversion.size() == 4 ? static_cast<std::size_t>(conversion[2] - '0') : 0;
    if (digits.size() < width) {
        digits.insert(0, width - digits.size(), '0');
    }
    return digits;
}

} // namespace

Camera orbit_camera(const Camera &camera, double degrees) {
    if (degrees == 0) {
        return camera;
    }
    Camera turned = camera;
    const glm::dvec3 axis = glm::normalize(camera.up);
    turned.position =
        camera.target + rotate_about(camera.position - camera.target, axis, degrees * std::numbers::pi / 180);
    return turned;
}

double orbit_degrees(double degrees, int i, int frames) { return degrees * i / frames; }

bool is_frame_pattern(std::string_view pattern) {
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (pattern.substr(i).starts_with("%%")) {
            ++i;
        } else if (conversion_length(pattern.substr(i)) != 0) {
            return true;
        }
    }
    return false;
}

std::string frame_name(std::string_view pattern, int i) {
    std::string name;
    int conversions = 0;
    for (std::size_t at = 0; at < pattern.size();) {
        const std::string_view rest = pattern.substr(at);
        const std::size_t length = conversion_length(rest);
        if (rest.starts_with("%%")) {
            name += '%';
            at += 2;
        } else if (length != 0) {
            name += padded_number(i, rest.substr(0, length));
            ++conversions;
            at += length;
        } else if (rest.front() == '%') {
            conversions = 0;
            break;
        } else {
            name += rest.front();
            ++at;
        }
    }
    if (conversions != 1) {
        throw InputError(
            "expected a file name with exactly one frame number such as %04d (%% for a percent sign), got '" +
            std::string(pattern) + "'");
    }
    return name;
}

} // namespace sandbox
