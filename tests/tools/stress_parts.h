#pragma once

#include "scene/scene.h"
#include "tools/stress_dice.h"

/// What stress scenes are made of. `unit` is the size of the object in the world: every other length follows it.
namespace sandbox::stress {

/// A shape about 1 in size and its file's own unit: shapes of any size, models with bad normals, with triangles of no
/// area, far from their origin.
struct StressShape {
    Shape shape;
    double size = 1; ///< in object units
    glm::dvec3 middle{0};
};
StressShape any_shape(StressDice &dice);
/// A surface with an inside to look at, with texture coordinates, some of which are far from 0.
StressShape open_shape(StressDice &dice);

/// Along each axis: squashed, drawn out, mirrored, 0.
glm::dvec3 any_scale(StressDice &dice, double unit);

/// `kind`: d directional, p point, a point with all attenuation, k l q with one coefficient, h hard cone, s soft cone
/// with exponent and attenuation.
Light any_light(StressDice &dice, char kind, double unit);

void any_material(StressDice &dice, Material &material);

} // namespace sandbox::stress
