#include "render/renderer.h"

#include "render/log_depth.h"
#include "render/mesh_buffers.h"
#include "render/placing.h"
#include "render/program_cache.h"
#include "render/uniforms.h"
#include "render/visibility.h"
#include "scene/space.h"
#include "shading/length_scale.h"
#include "shading/needs.h"

#include <glad/gl.h>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <chrono>
#include <cmath>

namespace sandbox {
namespace {

VertexLayout vertex_layout(const Features &f) {
    const bool flat = f.frequency == Frequency::flat;
    if (f.program == Program::full) {
        return {flat, true, true, flat};
    }
    const ProgramNeeds needs = derive_needs(f);
    const bool lit_flat = flat && needs.vertex.lit;
    return {lit_flat, needs.vertex.N, f.base == Base::texture, lit_flat && needs.vertex.P};
}

Texture upload_texture(const Image &image) {
    Texture texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    std::vector<glm::vec4> bottom_first;
    bottom_first.reserve(image.pixels.size());
    for (int y = image.size.height - 1; y >= 0; --y) {
        const auto row = image.pixels.begin() + static_cast<std::ptrdiff_t>(image.index(0, y));
        bottom_first.insert(bottom_first.end(), row, row + image.size.width);
    }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, image.size.width, image.size.height, 0, GL_RGBA, GL_FLOAT,
                 bottom_first.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

void clear(const Scene &scene, const Target &target) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    glViewport(0, 0, target.size().width, target.size().height);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    const glm::vec4 background(scene.background, 1);
    constexpr float far_depth = 1;
    glClearBufferfv(GL_COLOR, 0, glm::value_ptr(background));
    glClearBufferfv(GL_DEPTH, 0, &far_depth);
    if (target.has_object_ids()) {
        constexpr unsigned none[4] = {0, 0, 0, 0};
        glClearBufferuiv(GL_COLOR, 1, none);
    }
}

/// The surfaces' depth, a little nearer.
void put_lifted_depth(const GlProgram &program, const Camera &camera, double scale, int picture_height) {
    const LogDepth depth = log_depth(camera, scale);
    const double lift = depth.per_octave * std::log2(1 + line_lift(camera, picture_height));
    program.set("depth_per_octave", static_cast<float>(depth.per_octave));
    program.set("depth_at_1", static_cast<float>(depth.at_1 - lift));
}

double aspect_of(const Target &target) {
    return static_cast<double>(target.size().width) / static_cast<double>(target.size().height);
}

} // namespace

struct Renderer::Impl {
    Impl(Assets assets, ShaderParts shader_parts)
        : resources(std::move(assets)), parts(std::move(shader_parts)), programs(parts) {}

    MeshBuffers &buffers(const std::shared_ptr<const Mesh> &mesh) {
        return meshes.try_emplace(mesh, mesh, buffer_origin(*mesh)).first->second;
    }
    unsigned texture(const std::shared_ptr<const Image> &image) {
        auto found = textures.find(image);
        if (found == textures.end()) {
            found = textures.emplace(image, upload_texture(*image)).first;
        }
        return found->second.id();
    }
    /// Frees what only this cache still holds.
    void forget_unused() {
        std::erase_if(meshes, [](const auto &entry) { return entry.first.use_count() <= 2; });
        std::erase_if(textures, [](const auto &entry) { return entry.first.use_count() <= 1; });
    }

    void draw_object(const DrawInput &input, const ObjectResources &own, const Target &target, bool deep,
                     bool guarded) {
        const Features needed =
            derive_features(input.scene, input.technique, input.object, *own.mesh, target.has_object_ids(), deep);
        const Features features = guarded ? needed : without_guards(needed);
        require_drawable(features, input.scene, input.technique, input.object);
        const GlProgram &program = programs.get(features);
        glUseProgram(program.id());
        upload_uniforms(program, input);
        if (own.texture != nullptr && program.has("base_texture")) {
            glActiveTexture(GL_TEXTURE0);
            glBindTexture(GL_TEXTURE_2D, texture(own.texture));
        }
        set_culling(input.scene.camera, input.object, *own.mesh, input.aspect());
        buffers(own.mesh).draw(vertex_layout(features));
    }

    void draw(const Scene &scene, const Technique &technique, Target &target, bool guarded) {
        const auto loaded = resources.load(scene);
        const bool deep = is_deep(scene, loaded);
        clear(scene, target);
        (deep ? glEnable : glDisable)(GL_DEPTH_CLAMP); // deep programs clip by near and far themselves
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            const DrawInput input{scene,           technique,     scene.objects[i],
                                  *loaded[i].mesh, target.size(), static_cast<unsigned>(i + 1)};
            draw_object(input, loaded[i], target, deep, guarded);
        }
        glDisable(GL_DEPTH_CLAMP);
        glDisable(GL_CULL_FACE);
        glFrontFace(GL_CCW);
        forget_unused();
    }

    Resources resources;
    ShaderParts parts;
    ProgramCache programs;
    std::map<std::shared_ptr<const Mesh>, MeshBuffers> meshes;
    std::map<std::shared_ptr<const Image>, Texture> textures;
    std::unique_ptr<Target> own_target;
};

Renderer::Renderer(Assets assets, ShaderParts parts)
    : impl_(std::make_unique<Impl>(std::move(assets), std::move(parts))) {}
Renderer::~Renderer() = default;

void Renderer::draw(const Scene &scene, const Technique &technique, Target &target) {
    impl_->draw(scene, technique, target, true);
}

void Renderer::draw_unguarded(const Scene &scene, const Technique &technique, Target &target) {
    impl_->draw(scene, technique, target, false);
}

void Renderer::finish() { glFinish(); }

Frame Renderer::render(const Scene &scene, const Technique &technique, Size size, bool object_ids) {
    auto &target = impl_->own_target;
    if (target == nullptr || target->size() != size || target->has_object_ids() != object_ids) {
        target.reset();
        target = std::make_unique<Target>(size, object_ids);
    }
    const auto start = std::chrono::steady_clock::now();
    draw(scene, technique, *target);
    finish();
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    return {target->read_color(), object_ids ? target->read_object_ids() : std::vector<std::uint32_t>{}, time.count()};
}

void Renderer::draw_wireframe(const Scene &scene, Target &target, glm::vec3 color) {
    const auto resources = impl_->resources.load(scene);
    const bool deep = is_deep(scene, resources);
    const GlProgram &program = impl_->programs.wireframe(deep);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    glViewport(0, 0, target.size().width, target.size().height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_POLYGON_OFFSET_LINE); // no use where the program writes the depth: it lifts the lines itself
    glPolygonOffset(-1, -4);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glUseProgram(program.id());
    program.set("line_color", color);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object &object = scene.objects[i];
        set_culling(scene.camera, object, *resources[i].mesh, aspect_of(target));
        const Placing placing = place_object(scene, object, *resources[i].mesh);
        program.set("model_view_projection", glm::mat4(model_view_projection(scene, placing, aspect_of(target))));
        if (deep) {
            put_lifted_depth(program, scene.camera, placing.scale, target.size().height);
        }
        impl_->buffers(resources[i].mesh).draw({});
    }
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glDisable(GL_POLYGON_OFFSET_LINE);
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
}

bool Renderer::reload_changed_parts() {
    if (!impl_->parts.reload_changed()) {
        return false;
    }
    impl_->programs.rebuild_all();
    return true;
}

const std::string &Renderer::shader_error() const { return impl_->programs.error(); }
int Renderer::programs_built() const { return impl_->programs.built(); }
Resources &Renderer::resources() { return impl_->resources; }
const ShaderParts &Renderer::parts() const { return impl_->parts; }

} // namespace sandbox
