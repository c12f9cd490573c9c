#include "render/renderer.h"

#include "render/context.h"
#include "render/gl.h"
#include "render/gl_state.h"
#include "render/lifted.h"
#include "render/mesh_buffers.h"
#include "render/program_cache.h"
#include "render/seen_part.h"
#include "render/segment_pass.h"
#include "render/split_meshes.h"
#include "render/uniforms.h"
#include "render/window_grid.h"
#include "scene/space.h"
#include "shading/prepared_object.h"
#include "shading/vertex_marks.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <utility>

namespace sandbox {
namespace {

Texture upload_texture(const Image &image) {
    let_driver_catch_up(); // a browser waits with pixels until there is room for them
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
    check_gl("upload a texture");
    return texture;
}

/// What is drawn into.
struct Canvas {
    unsigned framebuffer;
    Size size;
    bool object_ids = false;
    std::optional<DisplayMap> shown; ///< what a screen shows; none: linear light
};
Canvas canvas_of(const Target &target) {
    return {target.framebuffer(), target.size(), target.has_object_ids(), std::nullopt};
}

glm::vec4 background_of(const Scene &scene, const Canvas &canvas) {
    Image background({1, 1});
    background.pixels[0] = glm::vec4(scene.background, 1);
    if (!canvas.shown) {
        return background.pixels[0];
    }
    const auto seen = to_display(background, canvas.shown->curve, canvas.shown->exposure).rgb;
    return glm::vec4(seen[0], seen[1], seen[2], 255) / 255.0F;
}

void clear(const Scene &scene, const Canvas &canvas) {
    const glm::vec4 background = background_of(scene, canvas);
    constexpr float far_depth = 1;
    glClearBufferfv(GL_COLOR, 0, glm::value_ptr(background));
    glClearBufferfv(GL_DEPTH, 0, &far_depth);
    if (canvas.object_ids) {
        constexpr unsigned none[4] = {0, 0, 0, 0};
        glClearBufferuiv(GL_COLOR, 1, none);
    }
}

ObjectDraw draw_of(const Scene &scene, std::size_t object, const Mesh &mesh, const PreparedObject &prepared,
                   const Canvas &canvas) {
    return {scene,
            scene.objects[object],
            mesh,
            prepared,
            canvas.size,
            static_cast<unsigned>(object + 1),
            canvas.shown ? canvas.shown->exposure : 1};
}

/// Skips back faces where they cannot be seen; a mirrored object's front faces run clockwise.
void set_culling(const Camera &camera, const Object &object, const Mesh &mesh, double aspect) {
    glFrontFace(is_mirrored(object.transform) ? GL_CW : GL_CCW);
    (back_faces_hidden(camera, aspect, object.transform, mesh) ? glEnable : glDisable)(GL_CULL_FACE);
}

/// Pixels of a picture 720 high, and as many more as one is higher.
constexpr double normal_width = 2, vertex_width = 5, stripe = 12;

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
        std::erase_if(meshes, [](const auto &entry) { return entry.second.unused(); });
        std::erase_if(textures, [](const auto &entry) { return entry.first.use_count() <= 1; });
        programs.end_frame();
        if (keeping.use_count() == 1) {
            programs.forget_unused();
            splits.forget_unused();
        }
    }

    /// What is written into the program.
    static UniformValues constants(const ObjectDraw &draw) {
        return draw.prepared.program.is_baked() ? uniform_values(draw) : UniformValues{};
    }

    void draw_object(const ObjectDraw &draw, const ObjectResources &own, const std::optional<TrianglePart> &triangles) {
        require_drawable(draw.prepared.features, draw.object);
        const GlProgram &program = programs.get(draw.prepared.program, constants(draw));
        glUseProgram(program.id());
        if (!program.uniforms().empty()) { // a baked program may have none
            upload_uniforms(program, draw);
        }
        // Without a texture nothing is bound: WebGL refuses what was, the target itself say.
        if (program.has("base_texture")) {
            glActiveTexture(GL_TEXTURE0);
            glBindTexture(GL_TEXTURE_2D, own.texture != nullptr ? texture(own.texture) : 0);
        }
        set_culling(draw.scene.camera, draw.object, draw.mesh, draw.aspect());
        buffers(own.mesh).draw(draw.prepared.needs.attributes, triangles);
    }

    /// An object or, under `auto`, a part of it.
    struct Part {
        std::size_t object;
        PreparedObject prepared;
        std::optional<TrianglePart> triangles{};
    };
    /// What a scene's objects are drawn with.
    struct Prepared {
        std::vector<ObjectResources> loaded;
        std::vector<Part> parts;
    };
    Prepared prepare(const Scene &scene, const Technique &technique, const Canvas &canvas, DrawOptions options) {
        Prepared prepared{resources.load(scene), {}};
        options.object_ids = canvas.object_ids;
        options.shown = canvas.shown;
        options.deep = is_deep(scene, prepared.loaded);
        if (options.guarded) {
            prepared.loaded = seen_parts(scene, technique, std::move(prepared.loaded), aspect_of(canvas.size));
        }
        if (technique.frequency == Frequency::automatic) {
            add_split(prepared, scene, technique, canvas, options);
            return prepared;
        }
        for (PreparedObject &object : prepare_objects(scene, technique, prepared.loaded, options)) {
            prepared.parts.push_back({prepared.parts.size(), std::move(object)});
        }
        return prepared;
    }
    void add_split(Prepared &prepared, const Scene &scene, const Technique &technique, const Canvas &canvas,
                   const DrawOptions &options) {
        const std::vector<SplitMesh> &split = splits.of(scene, technique, prepared.loaded, canvas.size);
        const auto cut =
            seen_parts(scene, part_of_auto(technique, Frequency::per_pixel), prepared.loaded, aspect_of(canvas.size));
        for (std::size_t i = 0; i < split.size(); ++i) {
            if (cut[i].mesh != prepared.loaded[i].mesh) { // so narrow a view has few triangles, and needs their digits
                prepared.loaded[i] = cut[i];
                prepared.parts.push_back(
                    {i, prepare_object(scene, technique, scene.objects[i], *cut[i].mesh, options)});
                continue;
            }
            for (const SplitMesh::Part &part : split[i].parts) {
                DrawOptions of_part = options;
                of_part.part = part.frequency;
                of_part.lights = part.lights;
                prepared.parts.push_back(
                    {i, prepare_object(scene, technique, scene.objects[i], *prepared.loaded[i].mesh, of_part),
                     part.triangles});
            }
        }
    }

    [[nodiscard]] bool drawn_elsewhere(const Technique &technique) const {
        return technique.model == Model::own && own_drawing && !technique.own.is_trusted();
    }

    /// The picture comes from elsewhere; the depth, which hides what is drawn over it, from here.
    void draw_own(const Scene &scene, const Technique &technique, Target &target) {
        const Frame frame = own_drawing(scene, technique, target.size(), target.has_object_ids());
        draw(scene, {.frequency = Frequency::flat, .model = Model::lambert}, canvas_of(target));
        target.write_color(frame.color);
    }

    void draw(const Scene &scene, const Technique &technique, const Canvas &canvas, const DrawOptions &options = {}) {
        if (drawn_elsewhere(technique)) {
            throw std::logic_error("own shading is drawn elsewhere");
        }
        const auto [loaded, parts_drawn] = prepare(scene, technique, canvas, options);
        const PassState pass(canvas.framebuffer, canvas.size, DepthTest::on);
        clear(scene, canvas);
        for (const Part &part : parts_drawn) {
            const ObjectResources &own = loaded[part.object];
            draw_object(draw_of(scene, part.object, *own.mesh, part.prepared, canvas), own, part.triangles);
        }
        forget_unused();
    }

    OwnDrawing own_drawing; ///< empty: own shading is drawn as everything else
    Resources resources;
    bool grid_is_known = false; ///< measured_window_grid() has been called for them
    ShaderParts parts;
    ProgramCache programs;
    SplitMeshes splits;
    std::shared_ptr<const int> keeping = std::make_shared<const int>(0); ///< others hold it: see keep_all()
    std::map<std::shared_ptr<const Mesh>, MeshBuffers> meshes;
    std::map<std::shared_ptr<const Image>, Texture> textures;
    /// Stripes on what `auto` lights per vertex.
    void draw_proved(const Scene &scene, const Technique &technique, const glm::vec3 &color, Target &target);
    /// Normals, or else vertices, over what the target shows.
    void draw_marks(const Scene &scene, const Technique &technique, bool normals, const glm::vec3 &color,
                    Target &target);

    std::unique_ptr<Target> own_target;
    std::optional<SegmentPass> segments;
};

void Renderer::Impl::draw_marks(const Scene &scene, const Technique &technique, bool normals, const glm::vec3 &color,
                                Target &target) {
    const auto loaded = resources.load(scene);
    const bool deep = is_deep(scene, loaded);
    const Size size = target.size();
    const double width = (normals ? normal_width : vertex_width) * std::max(1.0, size.height / 720.0);
    const double apart = rounded_length(scene.camera, normals ? normals_apart : vertices_apart);
    const bool flat = normals && technique.frequency == Frequency::flat;
    const GlProgram &program = programs.overlay("segment", deep);
    segments = segments ? std::move(segments) : std::optional<SegmentPass>(std::in_place);
    const PassState pass(target.framebuffer(), size, DepthTest::on);
    glDepthFunc(GL_LEQUAL);
    glUseProgram(program.id());
    program.set("line_color", color);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object &object = scene.objects[i];
        const EyeSpace space = eye_space(scene, object, *loaded[i].mesh);
        const auto &vertices = buffers(loaded[i].mesh).marked(flat, object.transform.scale, apart);
        std::vector<Segment> drawn;
        for (const MarkLine &line :
             normals ? normal_lines(vertices, scene, technique, object, space) : vertex_dots(vertices, scene, object)) {
            const MarkLine before = lifted(line, scene.camera, width, size.height);
            drawn.push_back({glm::vec3(before.from * space.scale), glm::vec3(before.to * space.scale)});
        }
        glm::dmat4 matrix = view_projection(scene.camera, aspect_of(target.size()));
        matrix[3] *= space.scale;
        program.set("model_view_projection", glm::mat4(matrix));
        if (deep) {
            program.set("depth_per_octave", static_cast<float>(space.depth_per_octave));
            program.set("depth_at_1", static_cast<float>(space.depth_at_1));
        }
        segments->draw(program, drawn, static_cast<float>(width / 2), target);
    }
}

void Renderer::Impl::draw_proved(const Scene &scene, const Technique &technique, const glm::vec3 &color,
                                 Target &target) {
    if (technique.frequency != Frequency::automatic) {
        return;
    }
    const auto loaded = resources.load(scene);
    const Size size = target.size();
    const std::vector<SplitMesh> &split = splits.of(scene, technique, loaded, size);
    const bool deep = is_deep(scene, loaded);
    const GlProgram &program = programs.overlay("hatch", deep);
    const PassState pass(target.framebuffer(), size, DepthTest::on);
    glDepthFunc(GL_LEQUAL);
    glUseProgram(program.id());
    program.set("line_color", color);
    program.set("stripe", static_cast<float>(stripe * std::max(1.0, size.height / 720.0)));
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object &object = scene.objects[i];
        const EyeSpace space = eye_space(scene, object, *loaded[i].mesh);
        put_lifted(program, scene, space, size, deep, stripes_lift);
        set_culling(scene.camera, object, *loaded[i].mesh, aspect_of(size));
        for (const SplitMesh::Part &part : split[i].parts) {
            if (part.frequency == Frequency::per_vertex) {
                buffers(loaded[i].mesh).draw({}, part.triangles);
            }
        }
    }
}

Renderer::Renderer(Assets assets, ShaderParts parts)
    : impl_(std::make_unique<Impl>(std::move(assets), std::move(parts))) {}
Renderer::~Renderer() = default;

void Renderer::draw_own_by(OwnDrawing own) { impl_->own_drawing = std::move(own); }

void Renderer::draw(const Scene &scene, const Technique &technique, Target &target) {
    if (impl_->drawn_elsewhere(technique)) {
        impl_->draw_own(scene, technique, target);
    } else {
        impl_->draw(scene, technique, canvas_of(target));
    }
}

void Renderer::draw_shown(const Scene &scene, const Technique &technique, const DisplayMap &map, ScreenTarget &target) {
    impl_->draw(scene, technique, {target.framebuffer(), target.size(), false, map});
}

std::vector<Features> Renderer::missing_programs(const Scene &scene, const Technique &technique, Size size,
                                                 const std::optional<DisplayMap> &map) {
    std::vector<Features> missing;
    const Canvas canvas{0, size, false, map};
    const auto [loaded, parts] = impl_->prepare(scene, technique, canvas, {});
    for (const auto &[object, prepared, triangles] : parts) {
        if (!impl_->programs.has(prepared.program,
                                 Impl::constants(draw_of(scene, object, *loaded[object].mesh, prepared, canvas)))) {
            missing.push_back(prepared.program);
        }
    }
    return missing;
}

std::vector<ObjectResources> Renderer::unchosen(const Scene &scene, const Technique &technique, Size size) {
    if (technique.frequency != Frequency::automatic) {
        return {};
    }
    std::vector<ObjectResources> objects = impl_->resources.load(scene);
    return impl_->splits.know(scene, technique, objects, size) ? std::vector<ObjectResources>{} : objects;
}

void Renderer::take_choice(const Scene &scene, const Technique &technique, Size size,
                           const std::vector<ObjectResources> &objects, const certificate::Choice &choice) {
    impl_->splits.take(scene, technique, objects, size, choice);
}

void Renderer::draw_unguarded(const Scene &scene, const Technique &technique, Target &target) {
    impl_->draw(scene, technique, canvas_of(target), {.guarded = false});
}

void Renderer::draw_mediump(const Scene &scene, const Technique &technique, Target &target) {
    impl_->draw(scene, technique, canvas_of(target), {.mediump = true});
}

bool Renderer::knows_precision() { return is_es(); }

Frame Renderer::render(const Scene &scene, const Technique &technique, Size size, bool object_ids) {
    if (impl_->drawn_elsewhere(technique)) {
        return impl_->own_drawing(scene, technique, size, object_ids);
    }
    auto &target = impl_->own_target;
    if (target == nullptr || target->size() != size || target->has_object_ids() != object_ids) {
        target.reset();
        target = std::make_unique<Target>(size, object_ids);
    }
    const auto start = std::chrono::steady_clock::now();
    const int built = programs_built();
    draw(scene, technique, *target);
    if (programs_built() > built) { // the driver compiles now, and the frame's time is none
        target->finish_in_turns();
    } else {
        target->finish();
    }
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    return {target->read_color(), object_ids ? target->read_object_ids() : std::vector<std::uint32_t>{}, time.count()};
}

void Renderer::draw_wireframe(const Scene &scene, Target &target, glm::vec3 color) {
    const auto resources = impl_->resources.load(scene);
    const bool deep = is_deep(scene, resources);
    const GlProgram &program = impl_->programs.overlay("wireframe", deep);
    const PassState pass(target.framebuffer(), target.size(), DepthTest::on);
    glDepthFunc(GL_LEQUAL);
    glUseProgram(program.id());
    program.set("line_color", color);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object &object = scene.objects[i];
        const EyeSpace space = eye_space(scene, object, *resources[i].mesh);
        put_lifted(program, scene, space, target.size(), deep, lines_lift);
        impl_->buffers(resources[i].mesh).draw_edges();
    }
}

void Renderer::draw_overlays(const Scene &scene, const Technique &technique, const Overlays &overlays, Target &target) {
    for (const OverlayKind &kind : overlay_kinds) {
        if (!(overlays.*kind.on) || kind.on == &Overlays::lights) {
            continue;
        }
        if (kind.on == &Overlays::wireframe) {
            draw_wireframe(scene, target, kind.color);
        } else if (kind.on == &Overlays::proved) {
            impl_->draw_proved(scene, technique, kind.color, target);
        } else {
            impl_->draw_marks(scene, technique, kind.on == &Overlays::normals, kind.color, target);
        }
    }
}

bool Renderer::reload_changed_parts() {
    if (!impl_->parts.reload_changed()) {
        return false;
    }
    impl_->programs.rebuild_all();
    return true;
}

void Renderer::forget_last_good_programs() { impl_->programs.forget_last_good(); }
const std::string &Renderer::shader_error() const { return impl_->programs.error(); }
int Renderer::programs_built() const { return impl_->programs.built(); }
std::shared_ptr<const void> Renderer::keep_all() { return impl_->keeping; }
Resources &Renderer::resources() {
    if (!impl_->grid_is_known) {
        impl_->grid_is_known = true;
        if (!Context::software()) { // Mesa's software renderers interpolate between the exact positions
            Impl probe(Assets("assets"), ShaderParts(Assets("shaders")));
            const auto draw = [&](const Scene &scene, const Technique &technique, Size size) {
                Target target(size);
                probe.draw(scene, technique, canvas_of(target));
                return target.read_color();
            };
            impl_->resources.set_window_grid(measured_window_grid(draw));
        }
    }
    return impl_->resources;
}
const ShaderParts &Renderer::parts() const { return impl_->parts; }

} // namespace sandbox
