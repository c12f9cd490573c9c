#pragma once

#include "render/gl_program.h"
#include "shading/constant_text.h"
#include "shading/features.h"
#include "shading/parts.h"

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

namespace sandbox {

/// Programs by the features themselves, built when first needed. A baked program is one by what is written into it,
/// too.
class ProgramCache {
  public:
    explicit ProgramCache(const ShaderParts &parts) : parts_(parts) {}

    /// Throws ShaderError, or InputError of own shading, where it cannot be built and no earlier build of the same
    /// features can stand in.
    const GlProgram &get(const Features &features, const UniformValues &constants = {});
    /// Would get() return at once?
    [[nodiscard]] bool has(const Features &features, const UniformValues &constants = {}) const;
    /// One constant colour, of NAME_vertex.glsl and NAME_fragment.glsl: wireframe, segment. `deep` as in Features.
    const GlProgram &overlay(const std::string &name, bool deep);

    void end_frame() { ++frames_; }
    /// Of programs that no late frame drew, the least recently used go: a driver may keep megabytes for each.
    void forget_unused();

    /// After the parts changed: each program is built again when next needed, its last good one kept in case.
    void rebuild_all();
    /// From here on, what the present parts do not build fails, whatever an earlier build could stand in.
    void forget_last_good();
    /// The last build error since then; empty when all is well.
    [[nodiscard]] const std::string &error() const { return error_; }
    [[nodiscard]] int built() const { return built_; }

  private:
    struct Entry {
        std::shared_ptr<const GlProgram> program;
        bool stale = false;     ///< the parts have changed since
        bool last_good = false; ///< the present parts do not build
        long last_frame = 0;    ///< that drew it
    };
    using Key = std::pair<Features, UniformValues>;
    /// Finds a key by references: a frame asks for each of its programs, and copies nothing.
    struct Less {
        using is_transparent = void;
        bool operator()(const auto &a, const auto &b) const {
            return std::tie(a.first, a.second) < std::tie(b.first, b.second);
        }
    };
    using Asked = std::pair<const Features &, const UniformValues &>;
    void build(Entry &entry, const Key &key);

    const ShaderParts &parts_;
    std::map<Key, Entry, Less> entries_;
    std::map<std::pair<std::string, bool>, GlProgram> overlays_; ///< by name and `deep`
    std::string error_;
    int built_ = 0;
    long frames_ = 0;
};

} // namespace sandbox
