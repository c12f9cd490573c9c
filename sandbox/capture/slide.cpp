#include "capture/slide.h"

#include "scene/space.h"
#include "teach/lesson_format.h"

namespace sandbox {

constexpr int slide_samples = 4;

PictureOptions slide_options(const LessonStep &step) {
    PictureOptions options;
    options.layout = parse_layout(words_of<StepLayout>[static_cast<std::size_t>(step.layout)]);
    options.left = *step.left;
    options.right = *step.right;
    options.mesh_factors = {step.mesh_factors.x, step.mesh_factors.y};
    options.size = slide_size;
    options.display = step.display;
    options.exposure = step.exposure;
    options.gain = step.gain;
    options.drawn_over = step;
    const bool lines = on_surfaces(step, options.layout) != Overlays{};
    options.samples = options.layout == Layout::difference || lines ? 1 : slide_samples;
    options.labels = true;
    if (step.look) {
        options.marks.ring = glm::dvec3(step.look->at, step.look->radius);
    }
    return options;
}

std::optional<glm::dvec3> ring_in_view(const LessonStep &step, const Camera &camera, Size view) {
    const PictureOptions slide = slide_options(step);
    if (!slide.marks.ring) {
        return std::nullopt;
    }
    const Size own = view_sizes(slide.layout, room_for_views(slide)).front();
    const double down = view_height(step.scene.camera, 1) / view_height(camera, 1);
    const double across = down * aspect_of(own) / aspect_of(view);
    const glm::dvec3 &ring = *slide.marks.ring;
    return glm::dvec3(0.5 + (ring.x - 0.5) * across, 0.5 + (ring.y - 0.5) * down, ring.z * down);
}

} // namespace sandbox
