#pragma once

#include "commands/common.h"

#include <CLI/CLI.hpp>
#include <functional>

namespace sandbox {

/// What the command line chose; returns the exit code. Empty until a command was parsed.
using Run = std::function<int()>;

/// Adds one subcommand: its options, its help, and, when it is chosen, what to run.
using AddCommand = void(CLI::App &app, CommonOptions &common, Run &run);

AddCommand add_list, add_capture, add_reference, add_compare, add_time, add_report, add_stability, add_glsl, add_view;
/// A new command is a file of its own, and its name here and above.
inline constexpr AddCommand *all_commands[]{add_list,   add_capture,   add_reference, add_compare, add_time,
                                            add_report, add_stability, add_glsl,      add_view};

/// The arguments of every command: --set, --shaders, --assets, --backend, -v.
void add_common_options(CLI::App &app, CommonOptions &common);

/// What the window opens with.
struct ViewFlags {
    std::string scene;                      ///< empty: a built-in one
    std::optional<std::string> left, right; ///< techniques; absent: a sidecar's or the window's own
};

/// Opens the window; returns the exit code.
int view_scene(const CommonOptions &common, const ViewFlags &flags);

} // namespace sandbox
