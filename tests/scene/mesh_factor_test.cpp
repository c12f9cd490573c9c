#include "scene/mesh_factor.h"

#include "image/error.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

Scene scene_of(const Shape &shape) {
    Scene scene;
    scene.objects.push_back({.name = "", .mesh = shape, .transform = {}, .material = {}});
    return scene;
}

template <class S> S times(const S &shape, double factor) {
    return std::get<S>(with_mesh_factor(scene_of(shape), factor).objects[0].mesh);
}

TEST(MeshFactor, MultipliesEveryCountAndNothingElse) {
    EXPECT_EQ(times(SphereShape{.radius = 0.7, .rings = 16, .segments = 32}, 0.25),
              (SphereShape{.radius = 0.7, .rings = 4, .segments = 8}));
    EXPECT_EQ(times(BoxShape{.size = {1, 2, 3}, .divisions = 5}, 2), (BoxShape{.size = {1, 2, 3}, .divisions = 10}));
    EXPECT_EQ(times(PlaneShape{.size = {3, 4}, .divisions = 8}, 0.5), (PlaneShape{.size = {3, 4}, .divisions = 4}));
    EXPECT_EQ(times(CylinderShape{.segments = 12, .rings = 3, .caps = false}, 4),
              (CylinderShape{.segments = 48, .rings = 12, .caps = false}));
    EXPECT_EQ(times(TorusShape{.rings = 20, .segments = 10}, 0.5), (TorusShape{.rings = 10, .segments = 5}));
    EXPECT_EQ(times(ObjShape{"vase.obj"}, 4), ObjShape{"vase.obj"});
}

TEST(MeshFactor, StaysWithinWhatAFileTakes) {
    EXPECT_EQ(times(SphereShape{.rings = 4, .segments = 4}, 0.25), (SphereShape{.rings = 2, .segments = 3}));
    EXPECT_EQ(times(BoxShape{.divisions = 1}, 0.25), BoxShape{.divisions = 1});
    EXPECT_EQ(times(SphereShape{.rings = 1024, .segments = 2048}, 4), (SphereShape{.rings = 2048, .segments = 2048}));
}

TEST(MeshFactor, TakesCountsFromAnotherShapeOfItsKind) {
    Shape shape = SphereShape{.radius = 2, .rings = 99, .segments = 99};
    set_tessellation(shape, SphereShape{.radius = 1, .rings = 10, .segments = 20}, 2);
    EXPECT_EQ(shape, Shape(SphereShape{.radius = 2, .rings = 20, .segments = 40}));
    set_tessellation(shape, BoxShape{}, 1);
    EXPECT_EQ(shape, Shape(SphereShape{.radius = 2})) << "a fresh sphere's";
}

TEST(MeshFactor, TextsRoundTrip) {
    for (const auto &[text, factor] :
         {std::pair("1/4", 0.25), {"1/3", 1.0 / 3}, {"2", 2.0}, {"1.5", 1.5}, {"1", 1.0}}) {
        EXPECT_EQ(mesh_factor_text(factor), text);
        EXPECT_EQ(parse_mesh_factor(text), factor);
    }
    EXPECT_EQ(parse_mesh_factor("0.25"), 0.25);
    for (const char *wrong : {"", "a", "1/", "/2", "1/0", "0/0", "0", "-1", "65", "1/65", "1/4x", "nan"}) {
        EXPECT_THROW(parse_mesh_factor(wrong), InputError) << wrong;
    }
}

} // namespace
} // namespace sandbox
