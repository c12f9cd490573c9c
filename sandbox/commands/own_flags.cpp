#include "commands/own_flags.h"

namespace sandbox {

void add_own_files(CLI::App &command, OwnFlags &flags, bool two_sides) {
    add_value(command, "--own", "FILE.glsl", flags.both,
              "The text of the model own, under flat, per-vertex or per-pixel (see: own --starter)");
    if (two_sides) {
        add_value(command, "--own-left", "FILE.glsl", flags.left, "... of the left technique alone");
        add_value(command, "--own-right", "FILE.glsl", flags.right, "... of the right technique alone");
    }
}

OwnTechniques::OwnTechniques(const OwnFlags &flags)
    : both_{"--own", read_own(flags.both)}, left_{"--own-left", read_own(flags.left)}, right_{"--own-right",
                                                                                              read_own(flags.right)} {}

Technique OwnTechniques::single(std::string_view flag, const std::string &text) { return parse(flag, text, nullptr); }
Technique OwnTechniques::left(const std::string &text) { return parse("--left", text, &left_); }
Technique OwnTechniques::right(const std::string &text) { return parse("--right", text, &right_); }

Technique OwnTechniques::parse(std::string_view flag, const std::string &text, File *side) {
    File &file = side != nullptr && side->own ? *side : both_;
    const Technique technique = with_flag(flag, [&] { return parse_technique_with(file.own, text); });
    file.used |= technique.model == Model::own;
    return technique;
}

void OwnTechniques::require_all_used() const {
    for (const File *file : {&both_, &left_, &right_}) {
        if (file->own && !file->used) {
            throw InputError("{}: no technique here has the model own, as in per-pixel/own", file->flag);
        }
    }
}

} // namespace sandbox
