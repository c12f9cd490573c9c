#include "scene/budget.h"
#include "scene/resources.h"
#include "tools/error_of.h"
#include "tools/temporary_folder.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

/// Of every shape as many as are built.
TEST(Budget, KnowsTheTrianglesOfAShapeBeforeItIsBuilt) {
    for (const Shape &shape : {Shape(SphereShape{1, 7, 9}), Shape(SphereShape{1, 2, 3}), Shape(BoxShape{{1, 2, 3}, 4}),
                               Shape(PlaneShape{{1, 2}, 5}), Shape(CylinderShape{1, 2, 9, 4, true}),
                               Shape(CylinderShape{1, 2, 9, 4, false}), Shape(TorusShape{1, 0.5, 7, 5})}) {
        EXPECT_EQ(triangles_of(shape), build_mesh(shape).triangles.size()) << shape.index();
    }
}

Scene spheres(int count) {
    Scene scene;
    for (int i = 0; i < count; ++i) {
        scene.objects.push_back({"ball " + std::to_string(i), SphereShape{1 + i / 100.0, 2048, 2048}, {}, {}, false});
    }
    return scene;
}

/// 8.4 million triangles each; nothing is built.
TEST(Budget, RefusesMeshesTogetherNamingTheOneThatIsTooMuch) {
    EXPECT_EQ(error_of([&] { Resources(Assets("assets")).load(spheres(3)); }),
              "objects[1] (\"ball 1\"): its mesh has 8384512 triangles, after 8384512 of others; a scene's meshes may "
              "have 10000000");
}

/// A PNG that is nothing but its header.
std::string png_header(unsigned width, unsigned height) {
    std::string out = "\x89PNG\r\n\x1a\n";
    const auto number = [&](unsigned value) {
        for (int shift = 24; shift >= 0; shift -= 8) {
            out += static_cast<char>(value >> static_cast<unsigned>(shift) & 0xffU);
        }
    };
    number(13);
    out += "IHDR";
    number(width);
    number(height);
    return out + std::string("\x08\x02\0\0\0", 5);
}

TEST(Budget, RefusesTexturesByTheirHeaders) {
    const TemporaryFolder folder;
    folder.write("big.png", png_header(20000, 20000));
    folder.write("half.png", png_header(4096, 4096));
    Scene scene;
    scene.objects = {{"floor", PlaneShape{}, {}, {}, false}};
    scene.objects[0].material.texture = folder.file("big.png");
    EXPECT_EQ(error_of([&] { Resources(Assets("assets")).load(scene); }),
              "objects[0] (\"floor\"): its texture " + folder.file("big.png") +
                  " is 20000x20000, 6.0 GB decoded; a scene's textures may take 512 MB");
    SceneBudget budget;
    budget.add_texture("objects[0]", "a.png", {4096, 4096});
    budget.add_texture("objects[1]", "b.png", {4096, 4096});
    EXPECT_EQ(error_of([&] {
                  budget.add_texture("objects[2]", "c.png", {1, 1});
              }),
              "objects[2]: its texture c.png is 1x1, 0 MB decoded, after 512 MB of others; a scene's textures may take "
              "512 MB");
}

} // namespace
} // namespace sandbox
