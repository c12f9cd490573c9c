// OpenGL's own fixed-function lighting against the double reference: a third party to the argument, written by neither
// home of the formula. Needs a compatibility context (Mesa has one); not part of the build. From a build folder B:
//   g++ -std=c++20 -Isandbox tests/tools/fixed_function/fixed_function_check.cpp B/libsandbox_core.a
//       -ljpeg -lEGL -lOpenGL -lpthread -o /tmp/fixed_function_check && /tmp/fixed_function_check
// Prints a line a scene; exit code 1 where a difference is above 1e-4 of linear colour. With a folder's name, writes
// scene.json there, its picture right.png, and what OpenGL draws where two of its switches are left as they are at
// first (unit-normals-off.png, local-viewer-off.png): pictures of another program for `diagnose`.
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include "image/image_file.h"
#include "measure/metrics/metrics.h"
#include "scene/resources.h"
#include "scene/scene_file.h"
#include "scene/space.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

using namespace sandbox;

namespace {

constexpr Size size{320, 240};

bool make_context() {
    const auto display_of =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    const EGLDisplay display = display_of(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (eglInitialize(display, nullptr, nullptr) != EGL_TRUE || eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
        return false;
    }
    constexpr std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                               3,
                                               EGL_CONTEXT_MINOR_VERSION,
                                               3,
                                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                               EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                                               EGL_NONE};
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
}

void make_target() {
    GLuint names[3];
    glGenFramebuffers(1, &names[0]);
    glGenRenderbuffers(2, &names[1]);
    glBindFramebuffer(GL_FRAMEBUFFER, names[0]);
    glBindRenderbuffer(GL_RENDERBUFFER, names[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, size.width, size.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names[1]);
    glBindRenderbuffer(GL_RENDERBUFFER, names[2]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, size.width, size.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, names[2]);
    glViewport(0, 0, size.width, size.height);
    for (const GLenum what : {GL_CLAMP_VERTEX_COLOR, GL_CLAMP_FRAGMENT_COLOR, GL_CLAMP_READ_COLOR}) {
        glClampColor(what, GL_FALSE);
    }
}

glm::dmat4 view_of(const Camera &camera) { return glm::lookAt(camera.position, camera.target, camera.up); }

void put_lights(const Scene &scene, bool local_viewer) {
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixd(glm::value_ptr(view_of(scene.camera)));
    const glm::vec4 ambient(scene.ambient, 1);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(ambient));
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, local_viewer ? 1 : 0);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light &light = scene.lights[i];
        const auto name = GL_LIGHT0 + static_cast<GLenum>(i);
        const bool directional = light.type == LightType::directional;
        const auto color = [&](GLenum what, double amount) {
            const glm::vec4 value(light.color * amount, 1);
            glLightfv(name, what, glm::value_ptr(value));
        };
        color(GL_AMBIENT, light.ambient);
        color(GL_DIFFUSE, light.diffuse);
        color(GL_SPECULAR, light.specular);
        const glm::vec4 position = directional ? glm::vec4(-light.direction, 0) : glm::vec4(light.position, 1);
        glLightfv(name, GL_POSITION, glm::value_ptr(position));
        const glm::vec3 direction(light.direction);
        glLightfv(name, GL_SPOT_DIRECTION, glm::value_ptr(direction));
        const bool spot = light.type == LightType::spot;
        glLightf(name, GL_SPOT_CUTOFF, spot ? static_cast<float>(light.cutoff_degrees) : 180.0F);
        glLightf(name, GL_SPOT_EXPONENT, spot ? static_cast<float>(light.exponent) : 0.0F);
        glLightf(name, GL_CONSTANT_ATTENUATION, static_cast<float>(light.attenuation.constant));
        glLightf(name, GL_LINEAR_ATTENUATION, static_cast<float>(light.attenuation.linear));
        glLightf(name, GL_QUADRATIC_ATTENUATION, static_cast<float>(light.attenuation.quadratic));
        glEnable(name);
    }
}

void draw(const Scene &scene, const Mesh &mesh) {
    const Object &object = scene.objects[0];
    const Material &material = object.material;
    for (const auto &[what, color] :
         {std::pair{GL_AMBIENT, material.ambient}, std::pair{GL_DIFFUSE, material.diffuse},
          std::pair{GL_SPECULAR, material.specular}, std::pair{GL_EMISSION, material.emission}}) {
        const glm::vec4 value(color, 1);
        glMaterialfv(GL_FRONT_AND_BACK, static_cast<GLenum>(what), glm::value_ptr(value));
    }
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, static_cast<float>(material.shininess));
    glm::dmat4 model(linear_part(object.transform));
    model[3] = glm::dvec4(object.transform.translate, 1);
    glLoadMatrixd(glm::value_ptr(view_of(scene.camera) * model));
    glBegin(GL_TRIANGLES);
    for (const glm::uvec3 &triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            glNormal3dv(glm::value_ptr(mesh.normals[triangle[corner]]));
            glVertex3dv(glm::value_ptr(mesh.positions[triangle[corner]]));
        }
    }
    glEnd();
}

/// Ids are the truth's: background pixels are those that stayed black and transparent.
Frame fixed_function(const Scene &scene, const Mesh &mesh, bool local_viewer = true) {
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (const GLenum what : {GL_DEPTH_TEST, GL_CULL_FACE, GL_LIGHTING, GL_NORMALIZE}) {
        glEnable(what);
    }
    for (GLenum light = 0; light < 8; ++light) {
        glDisable(GL_LIGHT0 + light);
    }
    glMatrixMode(GL_PROJECTION);
    const Camera &camera = scene.camera;
    const glm::dmat4 projection =
        glm::perspective(glm::radians(camera.fov_y_degrees), size.width / static_cast<double>(size.height),
                         camera.near_plane, camera.far_plane);
    glLoadMatrixd(glm::value_ptr(projection));
    put_lights(scene, local_viewer);
    draw(scene, mesh);
    Frame frame;
    frame.color.size = size;
    frame.color.pixels.resize(static_cast<std::size_t>(size.width) * size.height);
    frame.object_ids.resize(frame.color.pixels.size());
    for (int y = 0; y < size.height; ++y) {
        glm::vec4 *row = &frame.color.pixels[static_cast<std::size_t>(size.height - 1 - y) * size.width];
        glReadPixels(0, y, size.width, 1, GL_RGBA, GL_FLOAT, row);
    }
    for (std::size_t i = 0; i < frame.color.pixels.size(); ++i) {
        frame.object_ids[i] = frame.color.pixels[i].a > 0 ? 1 : 0;
    }
    return frame;
}

Scene ball(const char *name, const Light &light) {
    Scene scene;
    scene.name = name;
    scene.camera = {{1, 1.5, 4}, {0, 0, 0}, {0, 1, 0}, 40, 0.1, 50};
    scene.ambient = {0.05, 0.1, 0.15};
    scene.lights = {light};
    scene.objects = {{"ball", SphereShape{1, 24, 48}, {{0.1, 0, 0}, {20, 30, 0}, {1, 0.7, 1.2}}, {}, false}};
    scene.objects[0].material.diffuse = {0.8, 0.5, 0.3};
    scene.objects[0].material.ambient = {0.8, 0.5, 0.3};
    return scene;
}

std::vector<Scene> scenes() {
    Light light;
    light.position = {2, 2, 2.5};
    light.direction = {-2, -2, -2.5};
    light.color = {1, 0.9, 0.8};
    light.ambient = 0.1;
    light.attenuate_ambient = true; // as OpenGL does
    std::vector<Scene> list{ball("point", light)};
    light.attenuation = {0.5, 0.1, 0.05};
    list.push_back(ball("point, attenuated", light));
    light.type = LightType::spot;
    light.cutoff_degrees = light.inner_cutoff_degrees = 25;
    light.exponent = 10;
    list.push_back(ball("spot", light));
    light.cutoff_degrees = light.inner_cutoff_degrees = 9; // its edge on the ball
    list.push_back(ball("spot, narrow", light));
    light.type = LightType::directional;
    light.attenuation = {};
    list.push_back(ball("directional", light));
    list.push_back(list.back());
    list.back().name = "several";
    list.back().lights = {list[1].lights[0], list[2].lights[0], light};
    for (std::size_t i = 0, count = list.size(); i < count; ++i) {
        list.push_back(list[i]);
        list.back().name += ", n = 128";
        list.back().objects[0].material.shininess = 128;
    }
    return list;
}

void write_pictures(const std::filesystem::path &folder, const Scene &scene, const Mesh &mesh) {
    std::filesystem::create_directories(folder);
    write_file(folder / "scene.json", scene_text(scene));
    for (const bool local_viewer : {true, false}) {
        write_file(folder / (local_viewer ? "right.png" : "local-viewer-off.png"),
                   encode_png(to_display(fixed_function(scene, mesh, local_viewer).color)));
    }
}

} // namespace

int main(int argc, char **argv) {
    if (!make_context()) {
        std::puts("no compatibility context here");
        return 2;
    }
    std::printf("%s, OpenGL %s\n", glGetString(GL_RENDERER), glGetString(GL_VERSION));
    make_target();
    Resources resources{Assets("assets")};
    if (argc > 1) {
        const Scene scene = scenes().front();
        write_pictures(argv[1], scene, *resources.load(scene)[0].mesh);
        return 0;
    }
    bool good = true;
    for (const Scene &scene : scenes()) {
        const auto own = resources.load(scene);
        const ReferenceFrame truth = render_reference(scene, own, parse_technique("per-vertex/blinn-phong"), size);
        const Metrics metrics = compare(fixed_function(scene, *own[0].mesh), truth);
        std::printf("%-28s largest difference %.2e over %zu pixels (%zu at the outline, %zu at edges, %zu at jumps)\n",
                    scene.name.c_str(), metrics.norms.max_abs, metrics.compared_pixels, metrics.silhouette_pixels,
                    metrics.edge_pixels, metrics.jump_pixels);
        good = good && metrics.norms.max_abs <= 1e-4 && metrics.compared_pixels > 1000;
    }
    return good ? 0 : 1;
}
