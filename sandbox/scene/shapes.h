#pragma once

#include "scene/mesh.h"

/// The built-in shapes, each as the scene file's rules describe it (see scene_format.h).
namespace sandbox {

Mesh sphere_mesh(const SphereShape &shape);
Mesh box_mesh(const BoxShape &shape);
Mesh plane_mesh(const PlaneShape &shape);
Mesh cylinder_mesh(const CylinderShape &shape);
Mesh torus_mesh(const TorusShape &shape);

} // namespace sandbox
