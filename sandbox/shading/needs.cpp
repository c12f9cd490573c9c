#include "shading/needs.h"

#include "image/error.h"
#include "shading/own_text.h"
#include "shading/program_source.h"

namespace sandbox {
namespace {

bool lights_vertices(Frequency frequency) {
    return frequency == Frequency::flat || frequency == Frequency::per_vertex || frequency == Frequency::hybrid;
}

bool reads_n_dot_l(Gate gate) { return gate != Gate::view_facing && gate != Gate::none; }

/// `vectors`: this stage is handed L, H or R and the distance instead of finding them from P.
LightNeeds light_needs(const Features &f, const LightKind &kind, const StageNeeds &stage, Stage which, bool vectors) {
    const LightFeatures &light = f.lights[kind.type];
    LightNeeds n;
    n.adds_ambient = stage.ambient && light.ambient;
    n.adds_attenuated_ambient = stage.ambient && light.attenuated_ambient;
    n.adds_diffuse = stage.diffuse && light.diffuse;
    n.adds_specular = stage.specular && light.specular;
    n.any = n.adds_ambient || n.adds_attenuated_ambient || n.adds_diffuse || n.adds_specular;
    if (!n.any) {
        return n;
    }
    const Technique &technique = f.technique;
    const bool fading_terms = n.adds_attenuated_ambient || n.adds_diffuse || n.adds_specular;
    const bool reflects = n.adds_specular && f.exponent != Exponent::zero;
    const bool own_half = reflects && f.uses_half_vector() && !light.given_half_vector;
    const bool mirrors = reflects && f.mirrors_view();
    n.given_H = vectors && own_half;
    n.given_R = vectors && mirrors;
    n.uses_cone = light.cone() && fading_terms;
    n.fades = fading_terms && (light.attenuated() || light.cone());
    n.uses_n_dot_l = n.adds_diffuse || (n.adds_specular && reads_n_dot_l(technique.gate)) ||
                     ((n.adds_ambient || n.adds_attenuated_ambient) && technique.ambient == AmbientWhere::where_lit);
    n.uses_L = n.uses_n_dot_l || n.uses_cone || (!vectors && (own_half || mirrors));
    n.given_L = n.uses_L && kind.positional && vectors;
    n.finds_L = n.uses_L && kind.positional && !vectors;
    const bool attenuation = fading_terms && light.attenuated();
    const bool varying = which == Stage::fragment;
    n.given_attenuation = attenuation && varying && technique.attenuation == AttenuationAt::interpolated;
    n.finds_attenuation = attenuation && !n.given_attenuation;
    n.given_distance =
        n.finds_attenuation && varying && (vectors || technique.attenuation == AttenuationAt::distance_interpolated);
    n.finds_distance = n.finds_attenuation && !n.given_distance;
    n.uses_R = mirrors && !vectors;
    const bool asks_whether_seen = n.adds_specular && technique.gate == Gate::view_facing;
    n.uses_V = asks_whether_seen || (own_half && !vectors) || (mirrors && vectors);
    n.uses_N =
        n.uses_n_dot_l || (reflects && f.uses_half_vector()) || asks_whether_seen || (n.finds_L && light.on_surface);
    return n;
}

void derive_stage(StageNeeds &stage, const Features &f, Stage which, bool vectors) {
    bool ambient = false;
    bool diffuse = false;
    bool specular = false;
    for (const LightKind &kind : light_kinds) {
        const LightNeeds light = light_needs(f, kind, stage, which, vectors);
        stage.lights[kind.type] = light;
        stage.lit |= light.any;
        stage.P |= light.uses_P();
        stage.N |= light.uses_N || light.uses_R;
        stage.V |= light.uses_V || light.uses_R;
        stage.R |= light.uses_R;
        ambient |= light.adds_ambient || light.adds_attenuated_ambient;
        diffuse |= light.adds_diffuse;
        specular |= light.adds_specular;
    }
    stage.ambient = ambient;
    stage.diffuse = diffuse;
    stage.specular = specular;
    stage.separate_specular =
        specular && f.has_base() && !f.base_times_specular && f.technique.frequency != Frequency::hybrid;
    stage.V |= stage.N && f.turns_by_view();
    stage.P |= stage.V && f.technique.viewer == Viewer::local && !vectors;
}

/// What the vertex stage must find for what the fragment stage is handed.
void pass_on(ProgramNeeds &needs, const Features &f) {
    StageNeeds &vertex = needs.vertex;
    const StageNeeds &fragment = needs.fragment;
    const bool local = f.technique.viewer == Viewer::local;
    vertex.P |= fragment.P && !f.wide;
    vertex.N |= fragment.N;
    vertex.V |= needs.vectors && fragment.V && local;
    for (const LightKind &kind : light_kinds) {
        const LightNeeds &light = fragment.lights[kind.type];
        vertex.P |= light.given_distance || light.given_attenuation ||
                    (kind.positional && (light.given_L || light.given_H || light.given_R));
        vertex.N |= light.given_R || light.given_H || (light.given_L && f.lights[kind.type].on_surface);
        vertex.V |= light.given_H;
    }
    vertex.P |= vertex.V && local;
}

} // namespace

ProgramNeeds derive_needs(const Features &f) {
    ProgramNeeds needs;
    const bool at_vertices = lights_vertices(f.technique.frequency);
    const bool hybrid = f.technique.frequency == Frequency::hybrid;
    needs.vectors = f.technique.frequency == Frequency::interpolated_vectors;
    needs.vertex.ambient = needs.vertex.diffuse = at_vertices;
    needs.vertex.specular = at_vertices && !hybrid;
    needs.fragment.ambient = needs.fragment.diffuse = !at_vertices;
    needs.fragment.specular = !at_vertices || hybrid;
    derive_stage(needs.vertex, f, Stage::vertex, false);
    derive_stage(needs.fragment, f, Stage::fragment, needs.vectors);
    if (f.is_own()) {
        StageNeeds &stage = at_vertices ? needs.vertex : needs.fragment;
        stage.lit = true;
        stage.P = f.technique.own->reads_P;
        stage.N = f.technique.own->reads_N;
        stage.separate_specular = at_vertices && f.has_base();
    }
    needs.vertex.constant_ambient = f.ambient && needs.vertex.lit;
    needs.fragment.constant_ambient = f.ambient && !needs.vertex.lit;
    needs.both_sides = needs.vertex.lit && needs.vertex.N && f.turns_by_winding();
    pass_on(needs, f);
    const bool flat = f.technique.frequency == Frequency::flat && needs.vertex.lit;
    needs.attributes = {.flat = flat,
                        .normal = needs.vertex.N,
                        .uv = f.textured,
                        .centroid = flat && needs.vertex.P,
                        .color = f.colored};
    return needs;
}

int varying_components(const Features &f) {
    const ProgramNeeds needs = derive_needs(f);
    const StageNeeds &fragment = needs.fragment;
    const int lights = int(needs.vertex.lit) + int(needs.vertex.separate_specular);
    int vectors = (needs.both_sides ? 2 * lights : lights) + int(fragment.P && !f.wide) + int(fragment.N) +
                  int(needs.vectors && fragment.V && f.technique.viewer == Viewer::local) + int(f.chequered) +
                  int(f.colored);
    int scalars = f.textured ? 2 : 0;
    for (const LightKind &kind : light_kinds) {
        const LightNeeds &light = fragment.lights[kind.type];
        const int count = f.lights[kind.type].count;
        vectors += count * (int(light.given_L) + int(light.given_H) + int(light.given_R));
        scalars += count * (int(light.given_distance) + int(light.given_attenuation));
    }
    return 3 * vectors + scalars;
}

void require_drawable(const Features &f, const Object &object) {
    if (f.is_full()) {
        int count = 0;
        for (const LightFeatures &light : f.lights) {
            count += light.count;
        }
        if (const int most = full_program_capacity(f.technique.frequency, f.colored); count > most) {
            throw InputError("object '{}': interpolated-vectors with program=full carries at most {} "
                             "lights, this scene has {}: use program=specialised or another frequency",
                             object.name, most, count);
        }
        return;
    }
    const int needed = varying_components(f);
    if (needed > max_varying_components) {
        throw InputError("object '{}': this technique needs {} components between the shader stages for "
                         "its lights; OpenGL 3.3 guarantees {}: use fewer lights or another frequency",
                         object.name, needed, max_varying_components);
    }
}

} // namespace sandbox
