#pragma once

#include "commands/commands.h"
#include "shading/technique.h"

#include <string>
#include <vector>

/// --own FILE.glsl: techniques whose model may be `own`.
namespace sandbox {

/// As typed.
struct OwnFlags {
    std::string both, left, right; ///< files; empty: not given
};

/// --own and, for commands with two sides, --own-left and --own-right.
void add_own_files(CLI::App &command, OwnFlags &flags, bool two_sides);

/// Techniques as a command has them: one list, or two sides.
class OwnTechniques {
  public:
    /// Reads the files.
    explicit OwnTechniques(const OwnFlags &flags);

    /// The technique that `flag` says. Throws InputError naming the flag.
    Technique single(std::string_view flag, const std::string &text);
    Technique left(const std::string &text);
    Technique right(const std::string &text);
    /// Throws InputError if a file was given that no technique took.
    void require_all_used() const;

  private:
    struct File {
        std::string flag;
        OwnShader own;
        bool used = false;
    };
    Technique parse(std::string_view flag, const std::string &text, File *side);

    File both_, left_, right_;
};

} // namespace sandbox
