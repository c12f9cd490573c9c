#include "shading/needs.h"

#include "image/error.h"

#include <string>

namespace sandbox {
namespace {

bool lights_vertices(const Features &f) {
    return f.frequency == Frequency::flat || f.frequency == Frequency::per_vertex || f.frequency == Frequency::hybrid;
}

/// `vectors`: this stage is handed L, H or R and the distance instead of finding them from P.
LightNeeds light_needs(const Features &f, const LightFeatures &light, const StageNeeds &stage, Stage which,
                       bool positional, bool vectors) {
    LightNeeds n;
    n.adds_ambient = stage.ambient && light.ambient;
    n.adds_attenuated_ambient = stage.ambient && light.attenuated_ambient;
    n.adds_diffuse = stage.diffuse && light.diffuse;
    n.adds_specular = stage.specular && light.specular;
    n.any = n.adds_ambient || n.adds_attenuated_ambient || n.adds_diffuse || n.adds_specular;
    if (!n.any) {
        return n;
    }
    const bool fading_terms = n.adds_attenuated_ambient || n.adds_diffuse || n.adds_specular;
    const bool cone = light.hard_cone || light.soft_cone;
    const bool reflects = n.adds_specular && f.exponent != Exponent::zero;
    const bool own_half = reflects && f.model == Model::blinn_phong && !light.given_half_vector;
    const bool mirrors = reflects && f.model == Model::phong;
    n.given_H = vectors && own_half;
    n.given_R = vectors && mirrors;
    n.uses_cone = cone && fading_terms;
    n.fades = fading_terms && (light.attenuated() || cone);
    n.uses_n_dot_l = n.adds_diffuse || ((n.adds_ambient || n.adds_attenuated_ambient) && f.where_lit) ||
                     (n.adds_specular && f.gate == Gate::light_facing);
    n.uses_L = n.uses_n_dot_l || n.uses_cone || (!vectors && (own_half || mirrors));
    n.given_L = n.uses_L && positional && vectors;
    n.finds_L = n.uses_L && positional && !vectors;
    const bool attenuation = fading_terms && light.attenuated();
    const bool varying = which == Stage::fragment;
    n.given_attenuation = attenuation && varying && f.attenuation == AttenuationAt::interpolated;
    n.finds_attenuation = attenuation && !n.given_attenuation;
    n.given_distance =
        n.finds_attenuation && varying && (vectors || f.attenuation == AttenuationAt::distance_interpolated);
    n.finds_distance = n.finds_attenuation && !n.given_distance;
    n.uses_R = mirrors && !vectors;
    n.uses_V = (n.adds_specular && f.gate == Gate::view_facing) || (own_half && !vectors) || (mirrors && vectors);
    n.uses_N = n.uses_n_dot_l || (reflects && f.model == Model::blinn_phong) ||
               (n.adds_specular && f.gate == Gate::view_facing) || (n.finds_L && light.on_surface);
    return n;
}

void derive_stage(StageNeeds &stage, const Features &f, Stage which, bool vectors) {
    stage.directional = light_needs(f, f.directional, stage, which, false, vectors);
    stage.point = light_needs(f, f.point, stage, which, true, vectors);
    stage.spot = light_needs(f, f.spot, stage, which, true, vectors);
    for (const LightNeeds *light : {&stage.directional, &stage.point, &stage.spot}) {
        stage.lit |= light->any;
        stage.N |= light->uses_N;
        stage.V |= light->uses_V || light->uses_R;
        stage.R |= light->uses_R;
        stage.N |= light->uses_R;
        stage.P |= light->finds_L || light->finds_distance;
    }
    stage.ambient = stage.directional.adds_ambient || stage.point.adds_ambient || stage.spot.adds_ambient ||
                    stage.directional.adds_attenuated_ambient || stage.point.adds_attenuated_ambient ||
                    stage.spot.adds_attenuated_ambient;
    stage.diffuse = stage.directional.adds_diffuse || stage.point.adds_diffuse || stage.spot.adds_diffuse;
    stage.specular = stage.directional.adds_specular || stage.point.adds_specular || stage.spot.adds_specular;
    stage.separate_specular =
        stage.specular && f.base != Base::none && !f.base_times_specular && f.frequency != Frequency::hybrid;
    stage.V |= stage.N && f.two_sided;
    stage.P |= stage.V && f.viewer == Viewer::local && !vectors;
}

/// What the vertex stage must find for what the fragment stage is handed.
void pass_on(ProgramNeeds &needs, const Features &f) {
    StageNeeds &vertex = needs.vertex;
    const StageNeeds &fragment = needs.fragment;
    vertex.P |= fragment.P && !f.wide;
    vertex.N |= fragment.N;
    if (needs.vectors && fragment.V && f.viewer == Viewer::local) {
        vertex.V = true;
    }
    const auto hand = [&](const LightNeeds &light, const LightFeatures &features, bool positional) {
        vertex.P |= light.given_distance || light.given_attenuation ||
                    (positional && (light.given_L || light.given_H || light.given_R));
        vertex.N |= light.given_R || light.given_H || (light.given_L && features.on_surface);
        vertex.V |= light.given_H;
    };
    hand(fragment.directional, f.directional, false);
    hand(fragment.point, f.point, true);
    hand(fragment.spot, f.spot, true);
    vertex.P |= vertex.V && f.viewer == Viewer::local;
}

} // namespace

ProgramNeeds derive_needs(const Features &f) {
    ProgramNeeds needs;
    const bool at_vertices = lights_vertices(f);
    const bool hybrid = f.frequency == Frequency::hybrid;
    needs.vectors = f.frequency == Frequency::interpolated_vectors;
    needs.vertex.ambient = needs.vertex.diffuse = at_vertices;
    needs.vertex.specular = at_vertices && !hybrid;
    needs.fragment.ambient = needs.fragment.diffuse = !at_vertices;
    needs.fragment.specular = !at_vertices || hybrid;
    derive_stage(needs.vertex, f, Stage::vertex, false);
    derive_stage(needs.fragment, f, Stage::fragment, needs.vectors);
    needs.vertex.constant_ambient = f.ambient && needs.vertex.lit;
    needs.fragment.constant_ambient = f.ambient && !needs.vertex.lit;
    pass_on(needs, f);
    return needs;
}

int varying_components(const Features &f) {
    if (f.program == Program::full) {
        return f.frequency == Frequency::interpolated_vectors ? max_varying_components : 17;
    }
    const ProgramNeeds needs = derive_needs(f);
    const StageNeeds &fragment = needs.fragment;
    int vectors = int(needs.vertex.lit) + int(needs.vertex.separate_specular) + int(fragment.P && !f.wide) +
                  int(fragment.N) + int(needs.vectors && fragment.V && f.viewer == Viewer::local) +
                  int(f.base == Base::checker);
    int scalars = f.base == Base::texture ? 2 : 0;
    const auto add = [&](const LightNeeds &light, const LightFeatures &features) {
        vectors += features.count * (int(light.given_L) + int(light.given_H) + int(light.given_R));
        scalars += features.count * (int(light.given_distance) + int(light.given_attenuation));
    };
    add(fragment.directional, f.directional);
    add(fragment.point, f.point);
    add(fragment.spot, f.spot);
    return 3 * vectors + scalars;
}

void require_drawable(const Features &features, const Scene &scene, const Technique &technique, const Object &object) {
    const int needed = varying_components(features);
    if (needed > max_varying_components) {
        throw InputError("object '" + object.name + "': this technique needs " + std::to_string(needed) +
                         " components between the shader stages for its lights; OpenGL 3.3 guarantees " +
                         std::to_string(max_varying_components) + ": use fewer lights or another frequency");
    }
    if (features.program == Program::full && features.frequency == Frequency::interpolated_vectors) {
        const ContributingLights lights = contributing_lights(scene, technique, object);
        const std::size_t count = lights.directional.size() + lights.point.size() + lights.spot.size();
        if (count > full_program_max_vector_lights) {
            throw InputError("object '" + object.name + "': interpolated-vectors with program=full carries at most " +
                             std::to_string(full_program_max_vector_lights) + " lights, this scene has " +
                             std::to_string(count) + ": use program=specialised or another frequency");
        }
    }
}

} // namespace sandbox
