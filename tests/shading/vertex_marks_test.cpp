#include "reference/surface.h"
#include "scene/space.h"
#include "shading/vertex_marks.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

constexpr double rounding = 1e-12; // of a few operations in double, on numbers near 1

/// One vertex at (1, 1, 0) whose normal is at 45 degrees, on an object four times as wide as it is high.
struct Wide {
    Scene scene;
    Object object{"wide", BoxShape{}, {{0, 0, -2}, {}, {4, 1, 1}}, {}, false};
    std::vector<MarkedVertex> vertices{{{1, 1, 0}, glm::normalize(glm::dvec3(1, 1, 0))}};
    double length = 0;

    Wide() {
        scene.camera.position = {0, 0, 8};
        scene.camera.target = {0, 0, -2};
        length = normal_length * 2 * 10 * std::tan(std::acos(-1.0) / 8); // 45 degrees high, 10 away
    }
    /// From the vertex to the tip, in lengths of a unit normal.
    glm::dvec3 arrow(const std::string &technique) const {
        const EyeSpace space = eye_space(scene, object, build_mesh(object.mesh));
        const MarkLine line = normal_lines(vertices, scene, parse_technique(technique), object, space).at(0);
        EXPECT_EQ(line.from, glm::dvec3(4, 1, -10)) << "from the eye";
        return (line.to - line.from) / length;
    }
};

void expect_near(const glm::dvec3 &a, const glm::dvec3 &b) { EXPECT_LT(glm::distance(a, b), rounding); }

TEST(VertexMarks, ATipLiesWhereTheTechniquePutsTheNormal) {
    const Wide wide;
    // 45 degrees on the mesh: the surface there becomes four times as flat, its normal four times as steep.
    expect_near(wide.arrow("per-pixel/phong"), glm::normalize(glm::dvec3(1, 4, 0)));
    // Transformed as a direction in the surface would be, it leans the other way.
    expect_near(wide.arrow("per-pixel/phong:normals=model-matrix"), glm::normalize(glm::dvec3(4, 1, 0)));
    expect_near(wide.arrow("per-pixel/phong:normals=untransformed"), glm::normalize(glm::dvec3(1, 1, 0)));
    expect_near(wide.arrow("per-pixel/phong:normals=unnormalized"), glm::dvec3(4, 1, 0) / std::sqrt(2.0));
    expect_near(wide.arrow("per-pixel/phong:normals=view-space"), glm::normalize(glm::dvec3(1, 4, 0)));
}

TEST(VertexMarks, AMirroredObjectsCofactorsPointInwards) {
    Wide mirrored;
    mirrored.object.transform.scale = {-4, 1, 1};
    const EyeSpace space = eye_space(mirrored.scene, mirrored.object, build_mesh(BoxShape{}));
    const auto arrow = [&](const char *technique) {
        const MarkLine line =
            normal_lines(mirrored.vertices, mirrored.scene, parse_technique(technique), mirrored.object, space).at(0);
        return (line.to - line.from) / mirrored.length;
    };
    expect_near(arrow("per-pixel/phong"), glm::normalize(glm::dvec3(-1, 4, 0)));
    expect_near(arrow("per-pixel/phong:normals=cofactor"), glm::normalize(glm::dvec3(1, -4, 0)));
}

TEST(VertexMarks, TheyAreTheReferencesNormals) {
    Wide wide;
    wide.object.transform = {{1, 2, 3}, {20, -50, 70}, {0.5, -2, 3}};
    wide.scene.camera.position = {3, 4, 5};
    const double length = normal_length * height_at_target(wide.scene.camera);
    const EyeSpace space = eye_space(wide.scene, wide.object, build_mesh(BoxShape{}));
    for (const char *normals : {"inverse-transpose", "model-matrix", "untransformed", "cofactor"}) {
        const Technique technique = parse_technique(std::string("per-pixel/phong:normals=") + normals);
        const MarkLine line = normal_lines(wide.vertices, wide.scene, technique, wide.object, space).at(0);
        const glm::dmat3 matrix = reference::normal_matrix(linear_part(wide.object.transform), technique.normals);
        expect_near((line.to - line.from) / length, reference::transform_normal(matrix, wide.vertices[0].normal));
    }
}

TEST(VertexMarks, FlatShadingHasOneInTheMiddleOfEachTriangle) {
    const Mesh box = build_mesh(BoxShape{{2, 2, 2}, 1});
    const auto faces = marked_vertices(box, true);
    ASSERT_EQ(faces.size(), 12U);
    for (const MarkedVertex &face : faces) { // a third of the way to the diagonal's middle
        EXPECT_NEAR(glm::dot(face.position, face.normal), 1, rounding);
        EXPECT_NEAR(glm::length(face.position), std::sqrt(1 + 2.0 / 9), rounding);
    }
    EXPECT_EQ(marked_vertices(box, false).size(), 24U);
}

TEST(VertexMarks, ThinnedOutNoneIsNearerAndNoneIsFarFromAll) {
    const auto all = marked_vertices(build_mesh(SphereShape{1, 64, 128}), false);
    const glm::dvec3 scale(1, 2, 1);
    const double apart = 0.3;
    const auto kept = thinned_out(all, scale, apart);
    EXPECT_LT(kept.size(), all.size() / 20);
    for (std::size_t i = 0; i < kept.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_GE(glm::distance(scale * kept[i].position, scale * kept[k].position), apart);
        }
    }
    for (const MarkedVertex &vertex : all) {
        double nearest = 10;
        for (const MarkedVertex &other : kept) {
            nearest = std::min(nearest, glm::distance(scale * vertex.position, scale * other.position));
        }
        EXPECT_LT(nearest, apart);
    }
}

TEST(VertexMarks, AllThreeNormalsOfACornerStay) {
    const auto all = marked_vertices(build_mesh(BoxShape{{1, 1, 1}, 1}), false);
    EXPECT_EQ(thinned_out(all, glm::dvec3(1), 0.5).size(), 24U);
    EXPECT_EQ(thinned_out(all, glm::dvec3(1), 1.01).size(), 12U) << "two of a face's four are 1.41 apart";
}

TEST(VertexMarks, ALiftedLineKeepsItsPlaceInThePicture) {
    Camera camera;
    camera.target = {0.5, 0.2, 0};
    const MarkLine line{{0.3, -0.4, -5}, {-1, 0.2, -7}};
    for (const bool orthographic : {false, true}) {
        if (orthographic) {
            camera.projection = Projection::orthographic;
            camera.height = 4;
        }
        const MarkLine nearer = lifted(line, camera, 5, 720);
        for (const auto &[before, after] : {std::pair(line.from, nearer.from), std::pair(line.to, nearer.to)}) {
            const auto place = place_in_view(camera, 1.5, before), now = place_in_view(camera, 1.5, after);
            ASSERT_TRUE(place && now);
            EXPECT_LT(glm::distance(*place, *now), rounding);
            EXPECT_LT(glm::dot(after, camera_axes(camera).forward), glm::dot(before, camera_axes(camera).forward));
        }
    }
}

} // namespace
} // namespace sandbox
