#include "shading/prepared_object.h"

namespace sandbox {

PreparedObject prepare_object(const Scene &scene, const Technique &given, const Object &object, const Mesh &mesh,
                              const DrawOptions &options) {
    const Technique technique = part_of_auto(given, options.part);
    PreparedObject prepared;
    prepared.space = eye_space(scene, object, mesh, technique, options.guarded);
    prepared.lights = lights_on_object(scene, technique, object, options.lights);
    Features &features = prepared.features;
    features = derive_features(scene, technique, object, mesh, prepared.lights, prepared.space);
    features.object_ids = options.object_ids;
    if (options.shown) {
        features.shown = true;
        features.srgb = options.shown->curve == Display::srgb;
        features.exposed = options.shown->exposure != 1;
    }
    features.deep = options.deep || is_deep(scene.camera);
    features.mediump = options.mediump;
    features.invariant = given.frequency == Frequency::automatic;
    if (!options.guarded) {
        features = without_guards(features);
    }
    prepared.program = program_features(features);
    prepared.needs = derive_needs(prepared.program);
    return prepared;
}

std::vector<PreparedObject> prepare_objects(const Scene &scene, const Technique &technique,
                                            const std::vector<ObjectResources> &resources, DrawOptions options) {
    options.deep = options.deep || is_deep(scene, resources);
    std::vector<PreparedObject> objects;
    objects.reserve(scene.objects.size());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        objects.push_back(prepare_object(scene, technique, scene.objects[i], *resources[i].mesh, options));
    }
    return objects;
}

std::vector<Features> object_features(const Scene &scene, const Technique &technique,
                                      const std::vector<ObjectResources> &resources) {
    std::vector<Features> all;
    for (const PreparedObject &object : prepare_objects(scene, technique, resources)) {
        all.push_back(object.features);
    }
    return all;
}

bool same_picture(const Scene &scene, const Technique &a, const Technique &b,
                  const std::vector<ObjectResources> &resources) {
    return a == b ||
           (a.tolerance == b.tolerance && object_features(scene, a, resources) == object_features(scene, b, resources));
}

} // namespace sandbox
