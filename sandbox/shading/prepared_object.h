#pragma once

#include "scene/resources.h"
#include "shading/needs.h"

#include <optional>
#include <vector>

namespace sandbox {

/// What one draw of one object needs of scene and technique, decided once: programs, buffers and uniforms ask here.
struct PreparedObject {
    Features features;  ///< of the object
    Features program;   ///< what its program holds: the same, or everything
    ProgramNeeds needs; ///< of that program
    ObjectLights lights;
    EyeSpace space;
};

/// What a draw asks of its programs beside scene and technique.
struct DrawOptions {
    bool object_ids = false;
    std::optional<DisplayMap> shown{};     ///< drawn as a screen shows it; none: as linear light
    bool deep = false;                     ///< what is_deep(scene, resources) says; the camera alone may make it so too
    bool guarded = true;                   ///< false: without_guards()
    bool mediump = false;                  ///< as in Features
    Frequency part = Frequency::per_pixel; ///< of `auto`: which of its two
    LightSet lights = every_light;         ///< that add something to what is drawn
};

PreparedObject prepare_object(const Scene &scene, const Technique &given, const Object &object, const Mesh &mesh,
                              const DrawOptions &options = {});
/// Every object of the scene, in their order.
std::vector<PreparedObject> prepare_objects(const Scene &scene, const Technique &technique,
                                            const std::vector<ObjectResources> &resources, DrawOptions options = {});
/// The features of every object.
std::vector<Features> object_features(const Scene &scene, const Technique &technique,
                                      const std::vector<ObjectResources> &resources);

/// Do two techniques draw the scene with the same programs, fed the same numbers? Then their pictures are the same
/// bits.
bool same_picture(const Scene &scene, const Technique &a, const Technique &b,
                  const std::vector<ObjectResources> &resources);

} // namespace sandbox
