#pragma once

#include "scene/scene.h"

/// Moving a camera around its target.
namespace sandbox {

/// Turned by `degrees` about the axis through its target along its up vector, counter-clockwise seen from above. 0
/// gives the camera itself, to the last bit.
Camera orbit_camera(const Camera &camera, double degrees);

/// A camera as a turntable sees it: where it stands around its target, with `up` as the axle.
struct OrbitPose {
    double azimuth_degrees = 0;   ///< about `up`, counter-clockwise seen from above
    double elevation_degrees = 0; ///< above the plane that `up` is normal to, [-90, 90]
    double distance = 1;          ///< world units, camera to target
};

/// Where the turntable stops short of the poles, so that the picture never flips over.
constexpr double most_elevation_degrees = 89.5;

OrbitPose orbit_pose(const Camera &camera);
/// The camera moved to `pose` about its own target; the distance is kept between its clip planes.
Camera at_pose(Camera camera, OrbitPose pose);

/// Turned by hand, by angles in degrees. Stops at the poles; a camera already beyond them (a plan view) may stay there.
Camera orbited(const Camera &camera, double azimuth_degrees, double elevation_degrees);
/// The distance to the target times `factor`; of an orthographic camera its height.
Camera dollied(const Camera &camera, double factor);
/// Camera and target moved across the picture, in picture heights at the target: right and up positive.
Camera panned(Camera camera, double right, double up);

/// The camera with the other projection, which shows as much at the target.
Camera with_projection(Camera camera, Projection projection);

} // namespace sandbox
