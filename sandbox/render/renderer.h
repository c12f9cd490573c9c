#pragma once

#include "certificate/choice.h"
#include "image/image.h"
#include "render/target.h"
#include "scene/overlays.h"
#include "scene/resources.h"
#include "shading/features.h"
#include "shading/parts.h"
#include "shading/technique.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sandbox {

/// Draws a scene under a technique whose model is `own`; the last argument: with object ids.
using OwnDrawing = std::function<Frame(const Scene &, const Technique &, Size, bool)>;

/// Draws scenes with OpenGL 3.3 into float targets. Needs a current Context for all its life.
class Renderer {
  public:
    /// `parts` are the GLSL parts (inside the executable, or --shaders DIR).
    Renderer(Assets assets, ShaderParts parts);
    ~Renderer();
    Renderer(const Renderer &) = delete;
    Renderer &operator=(const Renderer &) = delete;

    /// From here on own shading that strangers wrote is drawn by `own` (see OwnProcess), never by this driver; then
    /// draw_shown() and draw_unguarded() throw std::logic_error for it.
    void draw_own_by(OwnDrawing own);

    /// Clears `target` and draws `scene` as `technique` says. Programs are built when first needed, and the last ones
    /// used are kept.
    /// Throws InputError if the technique is refused for this scene (too many varyings), ShaderError if a program does
    /// not build and no earlier one of the same view can stand in. Does not wait for the picture (see
    /// Target::finish()).
    void draw(const Scene &scene, const Technique &technique, Target &target);
    /// Likewise, as a screen shows it: the programs map the light themselves.
    void draw_shown(const Scene &scene, const Technique &technique, const DisplayMap &map, ScreenTarget &target);
    /// Those that draw() or, with a map, draw_shown() would have to build first. Throws InputError for what cannot be
    /// loaded.
    [[nodiscard]] std::vector<Features> missing_programs(const Scene &scene, const Technique &technique, Size size,
                                                         const std::optional<DisplayMap> &map = {});
    /// The objects whose triangles the frequency `auto` must choose before it can draw this, which takes longer than a
    /// frame; empty: none. Throws InputError for what cannot be loaded.
    [[nodiscard]] std::vector<ObjectResources> unchosen(const Scene &scene, const Technique &technique, Size size);
    /// What certificate::choose() gave elsewhere for what unchosen() returned: draw() need not choose.
    void take_choice(const Scene &scene, const Technique &technique, Size size,
                     const std::vector<ObjectResources> &objects, const certificate::Choice &choice);
    /// Without the guards that the scene needs (without_guards()): wrong, to measure what they cost.
    void draw_unguarded(const Scene &scene, const Technique &technique, Target &target);

    /// With a fragment stage whose floats are declared mediump: what this device makes of that. As draw() where it
    /// knows no precision.
    void draw_mediump(const Scene &scene, const Technique &technique, Target &target);
    /// True under OpenGL ES.
    static bool knows_precision();

    /// draw + finish + read back, timed around draw and finish by the wall clock.
    Frame render(const Scene &scene, const Technique &technique, Size size, bool object_ids = false);

    /// Over what `target` shows, which hides it: those of the overlays on surfaces that are on. Normals are as
    /// `technique` transforms them.
    void draw_overlays(const Scene &scene, const Technique &technique, const Overlays &overlays, Target &target);
    /// The wireframe alone, in `color` (linear RGB).
    void draw_wireframe(const Scene &scene, Target &target, glm::vec3 color);

    /// --shaders DIR: true if a part changed on disk since the last call; programs are then rebuilt when next needed.
    bool reload_changed_parts();
    /// From here on a program that the present parts do not build fails, whatever earlier one could stand in.
    void forget_last_good_programs();
    /// The last program's build error ("reflection_phong.glsl:31: ..."), empty when all is well.
    [[nodiscard]] const std::string &shader_error() const;
    /// How many programs were built so far (a technique seen lately builds none).
    [[nodiscard]] int programs_built() const;
    /// While what is returned lives, every program and every choice of `auto` is kept: frames timed in turns make none.
    [[nodiscard]] std::shared_ptr<const void> keep_all();

    /// What is loaded knows on which grid this renderer places vertices (ObjectResources::window_grid).
    [[nodiscard]] Resources &resources();
    [[nodiscard]] const ShaderParts &parts() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace sandbox
