#include "teach/marking/truth.h"

#include "measure/metrics/metrics.h"
#include "reference/reference.h"

#include <algorithm>

namespace sandbox {
namespace {

const auto *found_in(const auto &entries, const Scene &scene) {
    const auto found = std::ranges::find_if(entries, [&](const auto &entry) { return entry.first == scene; });
    return found == entries.end() ? nullptr : &found->second;
}

} // namespace

Truth::Truth(const Exercise &exercise, const MarkDraw &draw)
    : exercise_(exercise), draw_(draw), pictures_([this](const Scene &scene) { return draw_truth(scene); }) {}

const std::vector<std::uint32_t> &Truth::ids(const Scene &scene) {
    Scene unlit = scene; // every light and technique leaves the same triangles in the same places
    unlit.lights.clear();
    unlit.ambient = glm::dvec3(0);
    if (const auto *known = found_in(ids_, unlit)) {
        return *known;
    }
    Technique plain;
    plain.model = Model::lambert;
    auto drawn = draw_.trusted.picture(unlit, plain, exercise_.size, true).object_ids;
    return ids_.emplace_back(std::move(unlit), std::move(drawn)).second;
}

Image Truth::draw_truth(const Scene &scene) {
    const ReferenceFrame frame = render_reference(scene, draw_.trusted.load(scene), exercise_.target, exercise_.size);
    std::vector<std::uint8_t> mask;
    for (const PixelUse use : pixel_uses(ids(scene), frame)) {
        mask.push_back(use == PixelUse::compared ? 1 : 0);
    }
    masks_.emplace_back(scene, std::move(mask));
    return to_frame(frame).color;
}

const std::vector<std::uint8_t> &Truth::compared(const Scene &scene) {
    (void)pictures_.of(scene);
    return *found_in(masks_, scene);
}

} // namespace sandbox
