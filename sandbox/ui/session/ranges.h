#pragma once

namespace sandbox {

/// What a number may be (the scene file's own range) and the part of it that a slider runs over.
struct ControlRange {
    double low, high;               ///< typed values are held inside
    double slider_low, slider_high; ///< widened to hold the opened scene's value
    bool logarithmic = false;
    const char *format = "%.3g";
};

namespace ranges {

constexpr ControlRange intensity{0, 1e6, 0, 2, false, "%.3f"};
constexpr ControlRange shininess{0, 1e7, 1, 1e4, true, "%.4g"};
constexpr ControlRange blinn_exponent_scale{1e-3, 16, 0.25, 8, true, "%.3g"};
constexpr ControlRange spot_exponent{0, 1e5, 0, 128, false, "%.4g"};
constexpr ControlRange cutoff_degrees{0, 90, 0, 90, false, "%.1f"};
constexpr ControlRange attenuation{0, 1e9, 0, 2, false, "%.4g"};
constexpr ControlRange coordinate{-1e9, 1e9, -10, 10, false, "%.2f"};
constexpr ControlRange direction{-1e9, 1e9, -1, 1, false, "%.2f"};
constexpr ControlRange angle_degrees{-1e9, 1e9, -180, 180, false, "%.1f"};
constexpr ControlRange elevation_degrees{-89.5, 89.5, -89.5, 89.5, false, "%.1f"};
constexpr ControlRange scale{-1e15, 1e15, 0, 3, false, "%.3g"};
constexpr ControlRange length{1e-6, 1e9, 0.05, 5, false, "%.3g"};
constexpr ControlRange distance{1e-6, 1e9, 0.5, 50, true, "%.2f"};
constexpr ControlRange fov_y_degrees{1, 179, 10, 120, false, "%.1f"};
constexpr ControlRange exposure{0, 1e6, 0.05, 20, true, "%.3g"};
constexpr ControlRange gain{0.1, 1e9, 1, 1000, true, "%.4g"};
constexpr ControlRange rings{2, 2048, 2, 256, true, "%.0f"};
constexpr ControlRange segments{3, 2048, 3, 256, true, "%.0f"};
constexpr ControlRange bands{1, 2048, 1, 64, true, "%.0f"};
constexpr ControlRange box_divisions{1, 512, 1, 64, true, "%.0f"};
constexpr ControlRange plane_divisions{1, 1024, 1, 128, true, "%.0f"};
constexpr ControlRange cells{1, 1024, 1, 32, false, "%.0f"};

} // namespace ranges

} // namespace sandbox
