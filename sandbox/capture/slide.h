#pragma once

#include "capture/picture.h"
#include "teach/lesson.h"

#include <glm/vec3.hpp>
#include <optional>

/// A step of a lesson as a picture.
namespace sandbox {

constexpr Size slide_size{1280, 720};

/// Labelled, with the ring of where to look.
PictureOptions slide_options(const LessonStep &step);

/// The ring of the slide over the same place in a view of another size, which `camera` sees from where the step's does,
/// perhaps in a wider angle: x, y and radius as Marks::ring has them. None: the step has no ring.
std::optional<glm::dvec3> ring_in_view(const LessonStep &step, const Camera &camera, Size view);

} // namespace sandbox
