#include "scene/scene_file.h"
#include "tools/error_of.h"
#include "tools/temporary_folder.h"
#include "ui/session/open_file.h"
#include "ui/session/written_files.h"

#include "capture/sidecar.h"
#include "image/image_file.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace sandbox {
namespace {

const Technique gouraud = parse_technique("per-vertex/phong");
const Technique blinn = parse_technique("per-pixel/blinn-phong");

Session session_with(const Scene &scene) { return Session(document_of("ball", scene, gouraud, blinn)); }

double half_width(const Camera &camera, Size size) {
    return std::tan(camera.fov_y_degrees * std::numbers::pi / 360) * size.width / size.height;
}

TEST(Document, WideViewsShowTheScenesOwnAngle) {
    const Document document = document_of("ball", Scene{}, gouraud, blinn);
    EXPECT_EQ(scene_in_view(document, {1600, 900}), document.scene);
}

TEST(Document, NarrowViewsKeepTheirSides) {
    const Document document = document_of("ball", Scene{}, gouraud, blinn);
    const double wanted =
        std::tan(document.scene.camera.fov_y_degrees * std::numbers::pi / 360) * document.least_aspect;
    EXPECT_NEAR(half_width(scene_in_view(document, {500, 600}).camera, {500, 600}), wanted, 1e-12);
    EXPECT_LE(scene_in_view(document, {1, 8000}).camera.fov_y_degrees, 179);
}

TEST(Document, ACaptureIsShownAsItWasTaken) {
    TemporaryFolder folder;
    Scene scene;
    scene.objects = {Object{"ball", SphereShape{}, {}, {}, false}};
    Session session = session_with(scene);
    session.view.layout = Layout::wipe;
    session.view.divider = 0.25F;
    session.view.drawn_over.wireframe = true;
    session.document.exposure = 2;
    session.document.display = Display::srgb;
    const PictureOptions options = picture_options(session, {300, 600});
    const auto path = folder.path() / "a.png.json";
    const Scene seen = scene_in_view(session.document, {300, 600});
    write_file(path, sidecar_text(seen, options, {}));

    const OpenedFile file = open_file(path.string(), Assets("assets"));
    const Document restored = document_from(file, session_with(Scene{}));
    EXPECT_EQ(restored.left, gouraud);
    EXPECT_EQ(restored.right, blinn);
    EXPECT_EQ(restored.exposure, 2);
    EXPECT_EQ(restored.display, Display::srgb);
    ViewSettings view;
    take_view(view, file);
    EXPECT_EQ(view.layout, Layout::wipe);
    EXPECT_EQ(view.divider, 0.25F);
    EXPECT_TRUE(view.drawn_over.wireframe);
    session.view.layout = Layout::difference;
    session.view.gain = 17;
    session.view.difference_of = DifferenceOf::b_truth;
    write_file(path, sidecar_text(seen, picture_options(session, {300, 600}), {}));
    take_view(view, open_file(path.string(), Assets("assets")));
    EXPECT_EQ(view.gain, 17);
    EXPECT_EQ(view.difference_of, DifferenceOf::b_truth);
    EXPECT_EQ(scene_in_view(restored, {300, 600}), seen); // not widened a second time
}

TEST(Document, ATextbooksPictureLastsAsLongAsItsTechnique) {
    TemporaryFolder folder;
    Session session = session_with(Scene{});
    EXPECT_FALSE(session.document.left_is_textbook());
    session.document.textbook = session.document.left;
    EXPECT_TRUE(session.document.left_is_textbook());

    const auto path = folder.path() / "a.png.json";
    write_file(path, sidecar_text(Scene{}, picture_options(session, {300, 200}), {}));
    EXPECT_TRUE(document_from(open_file(path.string(), Assets("assets")), session_with(Scene{})).left_is_textbook());
    session.view.layout = Layout::single;
    session.view.show_right = true;
    EXPECT_EQ(picture_options(session, {300, 200}).flip, FlipSide::b) << "the picture is B's";

    session.document.left.model = Model::lambert;
    EXPECT_FALSE(session.document.left_is_textbook());
}

TEST(Document, ASceneWithoutCompareBringsNoTechnique) {
    TemporaryFolder folder;
    write_file(folder.path() / "ball.json", "{}");
    const OpenedFile file = open_file((folder.path() / "ball.json").string(), Assets("assets"));
    EXPECT_EQ(file.name, "ball");
    EXPECT_FALSE(file.left || file.right || file.layout || file.capture);
    Session session = session_with(Scene{});
    session.document.left = parse_technique("flat/lambert");
    EXPECT_EQ(document_from(file, session).left, session.document.left);
}

TEST(Document, ASceneOpensAsItsKeyCompareSays) {
    const OpenedFile file = open_file("three-point-lights", Assets("assets"));
    EXPECT_EQ(file.name, "three-point-lights");
    EXPECT_FALSE(file.capture);
    const Document document = document_from(file, session_with(Scene{}));
    EXPECT_EQ(to_string(document.left), document.scene.compare.left);
    EXPECT_EQ(to_string(document.right), document.scene.compare.right);
    ViewSettings view;
    view.layout = Layout::wipe;
    take_view(view, file);
    EXPECT_EQ(to_string(view.layout), document.scene.compare.layout);
}

/// A sidecar says how the window stood, so the scene does not.
TEST(Document, ASidecarGoesBeforeItsScenesCompare) {
    TemporaryFolder folder;
    Session session = session_with(Scene{});
    session.document.scene.compare = {"flat/lambert", "flat/phong", "difference"};
    const auto opened = [&](Layout layout) {
        session.view.layout = layout;
        const auto path = folder.path() / "a.png.json";
        write_file(path, sidecar_text(session.document.scene, picture_options(session, {300, 200}), {}));
        return open_file(path.string(), Assets("assets"));
    };
    const OpenedFile both = opened(Layout::wipe);
    EXPECT_EQ(both.left, gouraud);
    EXPECT_EQ(both.right, blinn);
    EXPECT_EQ(both.layout, Layout::wipe);
    const OpenedFile one = opened(Layout::single);
    EXPECT_EQ(one.left, gouraud);
    EXPECT_EQ(one.right, blinn);
    EXPECT_EQ(one.layout, Layout::single);
}

TEST(Document, ABadFileSaysWhatIsWrong) {
    TemporaryFolder folder;
    write_file(folder.path() / "opening.json", R"({"compare": {"right": "per-pixel/fong"}})");
    const std::string name = (folder.path() / "opening.json").string();
    EXPECT_TRUE(error_of([&] { open_file(name, Assets("assets")); }).starts_with(name + ": compare.right: "));
    const auto path = folder.path() / "bad.json";
    write_file(path, R"({"lights": [{"type": "torch"}]})");
    const std::string error = error_of([&] { open_file(path.string(), Assets("assets")); });
    EXPECT_NE(error.find("lights[0].type"), std::string::npos) << error;
}

TEST(CaptureFiles, NeverOverwrite) {
    TemporaryFolder folder;
    const auto first = free_name(folder.path(), "ball");
    EXPECT_EQ(first.filename(), "ball-001.png");
    write_file(first, "x");
    EXPECT_EQ(free_name(folder.path(), "ball").filename(), "ball-002.png");
    write_file(folder.path() / "ball-002.png.json", "x"); // a sidecar alone keeps its number, too
    EXPECT_EQ(free_name(folder.path(), "ball").filename(), "ball-003.png");
}

TEST(CaptureFiles, NamesStayInTheFolder) {
    TemporaryFolder folder;
    EXPECT_EQ(free_name(folder.path(), "../../a b").parent_path(), folder.path());
    EXPECT_EQ(free_name(folder.path(), "a/b").filename(), "a-b-001.png");
    EXPECT_EQ(free_name(folder.path(), "").filename(), "scene-001.png");
}

TEST(CaptureFiles, SideBySideHoldsBothViews) {
    Session session = session_with(Scene{});
    EXPECT_EQ(room_for_views(picture_options(session, {300, 200})), (Size{600, 200}));
    session.view.layout = Layout::single;
    session.view.show_right = true;
    EXPECT_EQ(picture_options(session, {300, 200}).flip, FlipSide::b);
    EXPECT_EQ(picture_options(session, {300, 200}).right, blinn);
    EXPECT_EQ(room_for_views(picture_options(session, {300, 200})), (Size{300, 200}));
}

TEST(Document, NarrowViewsOfAnOrthographicCameraShowMoreOfTheWorld) {
    Document document = document_of("a", {}, {}, {});
    document.scene.camera.projection = Projection::orthographic;
    document.scene.camera.height = 3;
    EXPECT_EQ(scene_in_view(document, {1200, 1000}).camera.height, 3);
    EXPECT_NEAR(scene_in_view(document, {600, 1000}).camera.height, 6, 1e-12) << "as wide as at an aspect of 1.2";
}

} // namespace
} // namespace sandbox
