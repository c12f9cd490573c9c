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

ScenePictures::ScenePictures(Scene scene, const DiagnosisDraw &draw, const PointSamples &samples)
    : scene_(std::move(scene)), sampled_(scene_), draw_(draw), samples_(samples) {
    sampled_.camera = sampled_camera(scene_.camera, samples_);
}

const Image *ScenePictures::samples(const Technique &technique) {
    const auto [place, is_new] = drawn_.try_emplace(technique);
    if (is_new) {
        Technique full = technique;
        full.program = Program::full;
        if (!why_refused(full)) {
            place->second = drawn(draw_, sampled_, full, samples_.size);
        }
        if (!place->second) {
            place->second = to_frame(render_reference(sampled_, draw_.load(sampled_), technique, samples_.size)).color;
        }
    }
    return place->second ? &*place->second : nullptr;
}

std::optional<Image> ScenePictures::cheap_whole(const Technique &technique) const {
    return cheap_picture(draw_, scene_, technique, samples_.full);
}

std::optional<Image> ScenePictures::whole(const Technique &technique) const {
    return drawn(draw_, scene_, technique, samples_.full);
}

} // namespace sandbox
