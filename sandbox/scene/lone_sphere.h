#pragma once

#include "scene/resources.h"
#include "scene/scene.h"

#include <string>
#include <vector>

/// A scene's lights on a single sphere: where highlights and meshes are easiest to see.
namespace sandbox {

struct LoneSphere {
    Scene scene;             ///< one object; the eye is where it was unless that is inside the sphere
    std::string of;          ///< the object's name in the scene it was made from; empty: it has none
    bool own = false;        ///< it is a sphere there; else a sphere stands in its place, with its material
    bool made_shiny = false; ///< there were no highlights: specular colour 0.5 and intensities 1 here
};

/// The first sphere of `scene` that its transform leaves round, else one in place of the first object; 64 rings. The
/// camera is turned to it and zoomed in, so that it fills a square picture, but does not move: every point of it is lit
/// as it is in the scene. `resources` are the scene's. Throws InputError for a scene without objects.
LoneSphere lone_sphere(const Scene &scene, const std::vector<ObjectResources> &resources);

} // namespace sandbox
