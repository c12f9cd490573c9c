#include "measure/stability/textbook.h"

#include "image/thread.h"
#include "reference/mesh_scene.h"
#include "scene/light_kind.h"
#include "scene/space.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <utility>

namespace sandbox {
namespace {

using reference::Hit;
using reference::MeshScene;

/// As graphics processors compute it: pow(x, n) = exp2(n log2 x).
float power(float x, float n) { return std::exp2(n * std::log2(x)); }

/// One object's vertices, in world space but for `local`.
struct TextbookObject {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec3> local;  ///< object space, for a checker
    std::vector<glm::vec2> clip;   ///< z and w of clip space
    std::vector<glm::vec3> colors; ///< per vertex; empty: the equation runs per pixel
};

/// z and w of clip space, by a matrix times a world position.
glm::vec2 clip_space(const Camera &camera, const glm::vec3 &p) {
    const glm::vec3 forward(camera_axes(camera).forward);
    const auto near = static_cast<float>(camera.near_plane);
    const auto far = static_cast<float>(camera.far_plane);
    const float w = glm::dot(forward, p) - glm::dot(forward, glm::vec3(camera.position));
    if (is_orthographic(camera)) {
        return {(2 * w - far - near) / (far - near), 1};
    }
    return {(far + near) / (far - near) * w - 2 * far / (far - near) * near, w};
}

TextbookObject transformed(const Camera &camera, const Object &object, const Mesh &mesh) {
    glm::dmat4 placed(linear_part(object.transform));
    placed[3] = glm::dvec4(object.transform.translate, 1);
    const glm::mat4 model(placed);
    const glm::mat3 normal_matrix = glm::transpose(glm::inverse(glm::mat3(model)));
    TextbookObject out;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        out.local.emplace_back(mesh.positions[i]);
        out.positions.emplace_back(model * glm::vec4(out.local.back(), 1));
        out.normals.push_back(normal_matrix *
                              (mesh.file_normals.empty() ? glm::vec3(mesh.normals[i]) : mesh.file_normals[i]));
        out.clip.push_back(clip_space(camera, out.positions.back()));
    }
    return out;
}

glm::vec3 checker_color(const Checker &checker, double half_extent, const glm::vec3 &p) {
    const auto cells = static_cast<float>(checker.cells);
    const glm::vec3 cell =
        glm::clamp(glm::floor(p * (cells / (2 * static_cast<float>(half_extent))) + cells / 2), 0.0F, cells - 1);
    return checker.colors[std::fmod(cell.x + cell.y + cell.z, 2.0F) == 0 ? 0 : 1];
}

float highlight_cosine(Model model, const glm::vec3 &n, const glm::vec3 &l, const glm::vec3 &v) {
    switch (model) {
    case Model::lambert:
    case Model::own:
        break;
    case Model::phong:
        return glm::dot(glm::reflect(-l, n), v);
    case Model::blinn_phong:
        return glm::dot(n, glm::normalize(l + v));
    }
    return 0;
}

/// All that one light adds at one point whose ambient and diffuse colours are multiplied by `base`.
glm::vec3 light_sum(const Light &light, const Material &material, const glm::vec3 &base, float shininess, Model model,
                    const glm::vec3 &p, const glm::vec3 &n, const glm::vec3 &v) {
    const bool positional = has_position(light);
    const glm::vec3 to_light = glm::vec3(light.position) - p;
    const glm::vec3 l = positional ? glm::normalize(to_light) : glm::normalize(-glm::vec3(light.direction));
    float strength = 1;
    if (positional) {
        const float d = glm::length(to_light);
        const auto &k = light.attenuation;
        strength = 1.0F / (static_cast<float>(k.constant) + static_cast<float>(k.linear) * d +
                           static_cast<float>(k.quadratic) * (d * d));
    }
    if (kind_of(light.type).conical) { // 180 degrees are a cone like any other
        const float c = glm::dot(-l, glm::normalize(glm::vec3(light.direction)));
        const float outer = std::cos(glm::radians(static_cast<float>(light.cutoff_degrees)));
        const float inner = std::cos(glm::radians(static_cast<float>(light.inner_cutoff_degrees)));
        strength *= glm::smoothstep(outer, inner, c) * power(glm::max(c, 0.0F), static_cast<float>(light.exponent));
    }
    const glm::vec3 color(light.color);
    const float n_dot_l = glm::dot(n, l);
    glm::vec3 sum =
        base * glm::vec3(material.diffuse) * color * (static_cast<float>(light.diffuse) * glm::max(n_dot_l, 0.0F));
    if (reflection(model).specular && n_dot_l > 0) {
        const float f = glm::max(highlight_cosine(model, n, l, v), 0.0F);
        const glm::vec3 tint = material.texture_modulates_specular ? base : glm::vec3(1);
        sum += tint * glm::vec3(material.specular) * color * (static_cast<float>(light.specular) * power(f, shininess));
    }
    const glm::vec3 ambient = base * glm::vec3(material.ambient) * color * static_cast<float>(light.ambient);
    return light.attenuate_ambient ? strength * (ambient + sum) : ambient + strength * sum;
}

/// A point of an object's surface: a vertex, or what was interpolated between three.
struct TextbookPoint {
    glm::vec3 position, normal, local;
};

class TextbookScene {
  public:
    TextbookScene(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &technique)
        : scene_(scene), resources_(resources), model_(technique.model), eye_(scene.camera.position) {
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            TextbookObject object = transformed(scene.camera, scene.objects[i], *resources[i].mesh);
            for (std::size_t v = 0; technique.frequency == Frequency::per_vertex && v < object.positions.size(); ++v) {
                if (v % 256 == 0) {
                    let_others_run();
                }
                object.colors.push_back(color(i, {object.positions[v], object.normals[v], object.local[v]}));
            }
            objects_.push_back(std::move(object));
        }
    }

    /// What the depth buffer holds, in [0, 1].
    [[nodiscard]] float depth(std::size_t object, const glm::uvec3 &triangle, const glm::vec3 &weights) const {
        const glm::vec2 zw = blend(objects_[object].clip, triangle, weights);
        return 0.5F * (zw.x / zw.y) + 0.5F;
    }

    [[nodiscard]] glm::vec3 color(std::size_t number, const glm::uvec3 &triangle, const glm::vec3 &weights) const {
        const TextbookObject &object = objects_[number];
        const auto at = [&](const std::vector<glm::vec3> &values) { return blend(values, triangle, weights); };
        return object.colors.empty() ? color(number, {at(object.positions), at(object.normals), at(object.local)})
                                     : at(object.colors);
    }

  private:
    template <typename Vector>
    static Vector blend(const std::vector<Vector> &values, const glm::uvec3 &triangle, const glm::vec3 &weights) {
        return weights.x * values[triangle.x] + weights.y * values[triangle.y] + weights.z * values[triangle.z];
    }

    [[nodiscard]] glm::vec3 color(std::size_t number, const TextbookPoint &point) const {
        const Material &material = scene_.objects[number].material;
        const glm::vec3 n = glm::normalize(point.normal); // two-sided or not
        const bool parallel = is_orthographic(scene_.camera);
        const glm::vec3 v =
            parallel ? -glm::vec3(camera_axes(scene_.camera).forward) : glm::normalize(eye_ - point.position);
        const double scale = reflection(model_).scaled_exponent ? scene_.blinn_exponent_scale : 1;
        const auto shininess = static_cast<float>(scale * material.shininess);
        const glm::vec3 base =
            material.checker ? checker_color(*material.checker, half_extent(*resources_[number].mesh), point.local)
                             : glm::vec3(1);
        glm::vec3 sum = glm::vec3(material.emission) + base * glm::vec3(material.ambient * scene_.ambient);
        for (const Light &light : scene_.lights) {
            sum += light.enabled ? light_sum(light, material, base, shininess, model_, point.position, n, v)
                                 : glm::vec3(0);
        }
        return sum;
    }

    const Scene &scene_;
    const std::vector<ObjectResources> &resources_;
    Model model_;
    glm::vec3 eye_;
    std::vector<TextbookObject> objects_;
};

/// The picture that is being drawn, and its depth buffer.
struct Drawing {
    Frame frame;
    std::vector<float> depths;
};

/// One side of one object: the nearest of its triangles is the reference's, then float32 depths decide.
void draw_side(Drawing &drawing, const TextbookScene &textbook, std::size_t object, const reference::RasterObject &side,
               const Camera &camera) {
    const std::vector<reference::RasterObject> alone{side};
    Image &image = drawing.frame.color;
    const reference::Rasteriser rasteriser(alone, image.size, reference::DepthRange(camera));
    for (std::size_t band = 0; band < rasteriser.bands(); ++band) {
        let_others_run();
        const std::vector<Hit> hits = rasteriser.draw(band);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            if (hits[i].object == 0) {
                continue;
            }
            const int x = static_cast<int>(i) % image.size.width;
            const int y = rasteriser.first_row(band) + static_cast<int>(i) / image.size.width;
            const glm::uvec3 &t = (*side.triangles)[hits[i].triangle];
            const glm::vec3 weights(reference::weights_at(side.triangle(hits[i].triangle), x + 0.5, y + 0.5));
            const std::size_t pixel = image.index(x, y);
            const float depth = textbook.depth(object, t, weights);
            if (depth < drawing.depths[pixel]) {
                drawing.depths[pixel] = depth;
                image.pixels[pixel] = glm::vec4(textbook.color(object, t, weights), 1);
                drawing.frame.object_ids[pixel] = static_cast<std::uint32_t>(object + 1);
            }
        }
    }
}

} // namespace

Frame textbook_picture(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &technique,
                       Size size) {
    const MeshScene meshes = reference::prepare_meshes(scene, resources, Technique{}, size);
    const TextbookScene textbook(scene, resources, technique);
    Drawing drawing;
    Image &image = drawing.frame.color;
    image = Image(size, glm::vec4(glm::vec3(scene.background), 1));
    drawing.frame.object_ids.assign(image.pixels.size(), 0);
    drawing.depths.assign(image.pixels.size(), 1);
    for (std::size_t object = 0; object < meshes.raster.size(); ++object) {
        for (const int hidden : {1, -1}) {
            let_others_run();
            reference::RasterObject side = meshes.raster[object];
            side.hidden = hidden;
            draw_side(drawing, textbook, object, side, scene.camera);
        }
    }
    return std::move(drawing.frame);
}

} // namespace sandbox
