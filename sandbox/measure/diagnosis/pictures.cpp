#include "measure/diagnosis/pictures.h"

#include "image/error.h"
#include "reference/reference.h"

#include <utility>

namespace sandbox {
namespace {

std::optional<Image> drawn(const DiagnosisDraw &draw, const Scene &scene, const Technique &technique, Size size) {
    try {
        return draw.picture(scene, technique, size, false).color;
    } catch (const InputError &) {
        return std::nullopt; // too many lights for its varyings or its arrays
    }
}

} // namespace

std::optional<Image> cheap_picture(const DiagnosisDraw &draw, const Scene &scene, Technique technique, Size size) {
    Technique full = technique;
    full.program = Program::full;
    std::optional<Image> image;
    if (!why_refused(full)) {
        image = drawn(draw, scene, full, size);
    }
    return image ? image : drawn(draw, scene, technique, size);
}

Image Sampler::drawn(const Scene &scene, const Technique &technique) {
    constexpr std::size_t many_triangles = 1'000'000;
    const std::vector<ObjectResources> resources = draw_.load(scene);
    std::size_t &triangles = triangles_[static_cast<std::size_t>(technique.frequency)];
    Technique full = technique;
    full.program = Program::full;
    if (triangles > many_triangles && !why_refused(full)) {
        if (auto image = sandbox::drawn(draw_, scene, full, samples_.size)) {
            return std::move(*image);
        }
    }
    for (const ObjectResources &object : resources) {
        triangles += object.mesh->triangles.size();
    }
    return reference_colors(scene, resources, technique, samples_.size);
}

ScenePictures::ScenePictures(Scene scene, Sampler &sampler)
    : scene_(std::move(scene)), sampled_(scene_), sampler_(sampler) {
    sampled_.camera = sampled_camera(scene_.camera, sampler.samples());
}

const Image &ScenePictures::samples(const Technique &technique) {
    const auto place = drawn_.find(technique);
    return place != drawn_.end() ? place->second
                                 : drawn_.emplace(technique, sampler_.drawn(sampled_, technique)).first->second;
}

std::optional<Image> ScenePictures::cheap_whole(const Technique &technique) const {
    return cheap_picture(sampler_.draw(), scene_, technique, sampler_.samples().full);
}

std::optional<Image> ScenePictures::whole(const Technique &technique) const {
    return drawn(sampler_.draw(), scene_, technique, sampler_.samples().full);
}

} // namespace sandbox
