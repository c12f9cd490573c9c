#pragma once

#include "scene/mesh.h"
#include "scene/scene.h"
#include "shading/technique.h"

/// Where a light stands, as an object's points see it; by the bounds of its mesh, so that the answer may be yes though
/// no point is there.
namespace sandbox {

/// Could the light lie on the object?
bool may_touch(const Light &light, const Object &object, const Mesh &mesh);

/// Could a point of the object see the light just opposite the viewer? Then it lies between the two.
bool may_oppose(const Light &light, const Scene &scene, const Technique &technique, const Object &object,
                const Mesh &mesh);

} // namespace sandbox
