#include "scene/scene_format.h"

#include <gtest/gtest.h>
#include <set>
#include <string>

namespace sandbox {
namespace {

template <class... T> struct Types {};
using Formats = Types<Attenuation, Light, Camera, Transform, SphereShape, BoxShape, PlaneShape, CylinderShape,
                      TorusShape, ObjShape, Checker, Material, Object, View, Opening, Scene>;

/// Calls f(T{}, field) for every row of every table.
template <class F> void for_each_row(F &&f) {
    [&]<class... T>(Types<T...>) { (for_each_field<T>([&](const auto &field) { f(T{}, field); }), ...); }(Formats{});
}

template <class M> constexpr bool is_number = std::is_same_v<M, double> || std::is_same_v<M, int>;
template <class M>
constexpr bool holds_numbers = is_number<M> || std::is_same_v<M, glm::dvec2> || std::is_same_v<M, glm::dvec3> ||
                               std::is_same_v<M, std::array<glm::dvec3, 2>>;

bool accepts(const Range &range, double value) {
    const bool inside = range.above_low ? value > range.low : value >= range.low;
    return value == range.or_exactly || (inside && value <= range.high);
}

TEST(SceneFormat, ControlsStayWithinTheSceneFile) {
    int sliders = 0;
    for_each_row([&]<class T, class M>(const T &, const Field<T, M> &field) {
        if constexpr (holds_numbers<M>) {
            if (!field.has_control || field.range.a_color) {
                return;
            }
            ++sliders;
            const Slider &slider = field.range.slider;
            EXPECT_TRUE(accepts(field.range, slider.low)) << format_of<T>.name << "." << field.key;
            EXPECT_TRUE(accepts(field.range, slider.high)) << format_of<T>.name << "." << field.key;
            EXPECT_LT(slider.low, slider.high) << format_of<T>.name << "." << field.key;
            EXPECT_TRUE(!slider.logarithmic || slider.low > 0) << format_of<T>.name << "." << field.key;
        }
    });
    EXPECT_GE(sliders, 30);
}

TEST(SceneFormat, TypedNumbersReachWhateverTheSceneFileTakes) {
    for_each_row([&]<class T, class M>(const T &, const Field<T, M> &field) {
        if constexpr (holds_numbers<M>) {
            const Range &range = field.range;
            for (const double typed :
                 {-1e300, -1.0, 0.0, 1e-300, 1e-3, 1.0, 100.0, 180.0, 1e300, range.low, range.high}) {
                const double taken = nearest_accepted(typed, range);
                EXPECT_TRUE(accepts(range, taken)) << format_of<T>.name << "." << field.key << " " << typed;
                EXPECT_TRUE(taken == typed || !accepts(range, typed) || typed == 1e-300) << field.key << " " << typed;
            }
        }
    });
    EXPECT_EQ(nearest_accepted(180, cone_angle), 180);
    EXPECT_EQ(nearest_accepted(120, cone_angle), 90);
    EXPECT_EQ(nearest_accepted(0, positive_length), 1e-6);
}

/// A property of another type would have no control.
TEST(SceneFormat, EveryControlCanBeMade) {
    for_each_row([&]<class T, class M>(const T &, const Field<T, M> &field) {
        const bool has_control = holds_numbers<M> || std::is_same_v<M, bool> || HasWords<M> || HasFormat<M>;
        EXPECT_TRUE(has_control || !field.has_control) << format_of<T>.name << "." << field.key;
    });
}

TEST(SceneFormat, KeysAndLabelsAreUniqueAndDocsAreSentences) {
    std::set<std::string> seen;
    for_each_row([&]<class T, class M>(const T &, const Field<T, M> &field) {
        const std::string name(format_of<T>.name);
        EXPECT_TRUE(seen.insert(name + " key " + std::string(field.key)).second) << name << "." << field.key;
        EXPECT_TRUE(!field.has_control || seen.insert(name + " label " + std::string(field.rules.label)).second)
            << name << "." << field.key;
        EXPECT_TRUE(field.doc.ends_with('.') || field.doc.ends_with('?')) << name << "." << field.key;
    });
}

} // namespace
} // namespace sandbox
