#pragma once

#include "scene/scene.h"

#include <array>
#include <string>
#include <string_view>

/// Meshes made coarser or finer: factors on the counts (rings, segments, divisions) of the built-in shapes. Models from
/// files have none and stay as they are.
namespace sandbox {

/// Of A and of B.
using MeshFactors = std::array<double, 2>;
constexpr double least_mesh_factor = 1.0 / 64, most_mesh_factor = 64;

/// Gives `shape` the counts of `like` times `factor`, rounded and within what a scene file takes; those of a fresh
/// shape where `like` is of another kind.
void set_tessellation(Shape &shape, const Shape &like, double factor);
/// Every object's counts times `factor`; 1 gives the scene itself.
Scene with_mesh_factor(Scene scene, double factor);

/// "1/4", "2", "0.3".
std::string mesh_factor_text(double factor);
/// Throws InputError unless `text` is "1/4" or "0.25", from 1/64 to 64.
double parse_mesh_factor(std::string_view text);
/// The factor itself. Throws InputError unless it is from 1/64 to 64.
double checked_mesh_factor(double factor);

} // namespace sandbox
