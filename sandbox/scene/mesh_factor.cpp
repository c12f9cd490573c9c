#include "scene/mesh_factor.h"

#include "image/error.h"
#include "image/number.h"
#include "scene/scene_format.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <type_traits>
#include <utility>

namespace sandbox {
namespace {

double parse_number(std::string_view text) {
    double value = 0;
    const auto [end, error] = read_number(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
        throw InputError("expected a factor such as 1/4, 0.25 or 2, got '{}'", text);
    }
    return value;
}

} // namespace

void set_tessellation(Shape &shape, const Shape &like, double factor) {
    std::visit(
        [&]<class S>(S &own) {
            const S *same_kind = std::get_if<S>(&like);
            const S from = same_kind != nullptr ? *same_kind : S{};
            for_each_field<S>([&](const auto &field) {
                if constexpr (std::is_same_v<std::remove_cvref_t<decltype(own.*field.member)>, int>) {
                    const double count = std::round(from.*field.member * factor);
                    own.*field.member = static_cast<int>(nearest_accepted(count, field.range));
                }
            });
        },
        shape);
}

Scene with_mesh_factor(Scene scene, double factor) {
    if (factor != 1) {
        for (Object &object : scene.objects) {
            set_tessellation(object.mesh, Shape(object.mesh), factor);
        }
    }
    return scene;
}

std::string mesh_factor_text(double factor) {
    const double divisor = std::round(1 / factor);
    return divisor > 1 && 1 / divisor == factor ? fmt::format("1/{}", divisor) : fmt::format("{:.4g}", factor);
}

double parse_mesh_factor(std::string_view text) {
    const std::size_t slash = text.find('/');
    const double above = parse_number(text.substr(0, slash));
    return checked_mesh_factor(slash == std::string_view::npos ? above : above / parse_number(text.substr(slash + 1)));
}

double checked_mesh_factor(double factor) {
    if (!(factor >= least_mesh_factor && factor <= most_mesh_factor)) {
        throw InputError("expected a factor from 1/64 to 64, got {}", factor);
    }
    return factor;
}

} // namespace sandbox
