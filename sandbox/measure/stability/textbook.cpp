#include "measure/stability/textbook.h"

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
#include <glm/vec4.hpp>

namespace sandbox {
namespace {

using reference::Hit;
using reference::MeshScene;

/// As graphics processors compute it: pow(x, n) = exp2(n log2 x).
float power(float x, float n) { return std::exp2(n * std::log2(x)); }

/// One object's vertices in world space.
struct TextbookObject {
    std::vector<glm::vec3> positions, normals;
};

TextbookObject transformed(const Object &object, const Mesh &mesh) {
    glm::dmat4 placed(linear_part(object.transform));
    placed[3] = glm::dvec4(object.transform.translate, 1);
    const glm::mat4 model(placed);
    const glm::mat3 normal_matrix = glm::transpose(glm::inverse(glm::mat3(model)));
    TextbookObject out;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        out.positions.emplace_back(model * glm::vec4(glm::vec3(mesh.positions[i]), 1));
        out.normals.push_back(normal_matrix * glm::vec3(mesh.normals[i]));
    }
    return out;
}

float highlight_cosine(Model model, const glm::vec3 &n, const glm::vec3 &l, const glm::vec3 &v) {
    switch (model) {
    case Model::lambert:
        break;
    case Model::phong:
        return glm::dot(glm::reflect(-l, n), v);
    case Model::blinn_phong:
        return glm::dot(n, glm::normalize(l + v));
    }
    return 0;
}

/// All that one light adds at one point.
glm::vec3 light_sum(const Light &light, const Material &material, float shininess, Model model, const glm::vec3 &p,
                    const glm::vec3 &n, const glm::vec3 &v) {
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
    if (has_cone(light)) {
        const float c = glm::dot(-l, glm::normalize(glm::vec3(light.direction)));
        const float outer = std::cos(glm::radians(static_cast<float>(light.cutoff_degrees)));
        const float inner = std::cos(glm::radians(static_cast<float>(light.inner_cutoff_degrees)));
        strength *= glm::clamp((c - outer) / (inner - outer), 0.0F, 1.0F) *
                    power(glm::max(c, 0.0F), static_cast<float>(light.exponent));
    }
    const glm::vec3 color(light.color);
    const float n_dot_l = glm::dot(n, l);
    glm::vec3 sum = glm::vec3(material.diffuse) * color * (static_cast<float>(light.diffuse) * glm::max(n_dot_l, 0.0F));
    if (reflection(model).specular && n_dot_l > 0) {
        const float f = glm::max(highlight_cosine(model, n, l, v), 0.0F);
        sum += glm::vec3(material.specular) * color * (static_cast<float>(light.specular) * power(f, shininess));
    }
    const glm::vec3 ambient = glm::vec3(material.ambient) * color * static_cast<float>(light.ambient);
    return light.attenuate_ambient ? strength * (ambient + sum) : ambient + strength * sum;
}

class TextbookScene {
  public:
    TextbookScene(const Scene &scene, const std::vector<ObjectResources> &resources, Model model)
        : scene_(scene), model_(model), eye_(scene.camera.position) {
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            objects_.push_back(transformed(scene.objects[i], *resources[i].mesh));
        }
    }

    /// `back`: the triangle's corners run clockwise on the screen.
    [[nodiscard]] glm::vec3 color(const Hit &hit, const glm::uvec3 &triangle, const glm::vec3 &weights,
                                  bool back) const {
        const Object &object = scene_.objects[hit.object - 1];
        const TextbookObject &world = objects_[hit.object - 1];
        const auto blend = [&](const std::vector<glm::vec3> &v) {
            return weights.x * v[triangle.x] + weights.y * v[triangle.y] + weights.z * v[triangle.z];
        };
        const glm::vec3 p = blend(world.positions);
        glm::vec3 n = glm::normalize(blend(world.normals));
        const bool parallel = is_orthographic(scene_.camera);
        const glm::vec3 v = parallel ? -glm::vec3(camera_axes(scene_.camera).forward) : glm::normalize(eye_ - p);
        n = object.two_sided && back ? -n : n;
        const double scale = reflection(model_).scaled_exponent ? scene_.blinn_exponent_scale : 1;
        const auto shininess = static_cast<float>(scale * object.material.shininess);
        glm::vec3 sum = glm::vec3(object.material.emission) + glm::vec3(object.material.ambient * scene_.ambient);
        for (const Light &light : scene_.lights) {
            sum += light_sum(light, object.material, shininess, model_, p, n, v);
        }
        return sum;
    }

  private:
    const Scene &scene_;
    Model model_;
    glm::vec3 eye_;
    std::vector<TextbookObject> objects_;
};

} // namespace

Frame textbook_picture(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &technique,
                       Size size) {
    const MeshScene meshes = reference::prepare_meshes(scene, resources, Technique{}, size);
    const reference::Rasteriser rasteriser(meshes.raster, size, reference::DepthRange(scene.camera));
    const TextbookScene textbook(scene, resources, technique.model);
    Frame frame;
    frame.color = Image(size, glm::vec4(glm::vec3(scene.background), 1));
    frame.object_ids.assign(frame.color.pixels.size(), 0);
    for (std::size_t band = 0; band < rasteriser.bands(); ++band) {
        const std::vector<Hit> hits = rasteriser.draw(band);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            const Hit &hit = hits[i];
            if (hit.object == 0) {
                continue;
            }
            const int x = static_cast<int>(i) % size.width;
            const int y = rasteriser.first_row(band) + static_cast<int>(i) / size.width;
            const auto &raster = meshes.raster[hit.object - 1];
            const glm::uvec3 &t = (*raster.triangles)[hit.triangle];
            const reference::Triangle triangle = raster.triangle(hit.triangle);
            const glm::vec3 weights(reference::weights_at(triangle, x + 0.5, y + 0.5));
            const bool back = reference::orientation(triangle) > 0;
            const std::size_t pixel = frame.color.index(x, y);
            frame.color.pixels[pixel] = glm::vec4(textbook.color(hit, t, weights, back), 1);
            frame.object_ids[pixel] = hit.object;
        }
    }
    return frame;
}

} // namespace sandbox
