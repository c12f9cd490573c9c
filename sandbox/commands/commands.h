#pragma once

#include "commands/common.h"

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>

namespace sandbox {

/// What the command line chose; returns the exit code.
using Run = std::function<int()>;

/// Adds every subcommand to `app`. `run` becomes the one that is chosen, or opening the window if none is.
void add_commands(CLI::App &app, CommonOptions &common, Run &run);

/// What --help says below the options: techniques (from their own table), scenes, exit codes.
std::string help_footer();

/// The options of every command: --set, --shaders, --assets, --backend, -v.
void add_common_options(CLI::App &command, CommonOptions &common);

/// SCENE, required.
void add_scene(CLI::App &command, std::string &scene,
               const std::string &description = "Built-in name, or path of a .json or .obj file");
/// --view NAME.
void add_view_name(CLI::App &command, std::string &view);

/// An option as help shows it: "--frames N   description".
template <typename Value>
CLI::Option *add_value(CLI::App &command, const std::string &option, const std::string &type, Value &value,
                       const std::string &description) {
    return command.add_option(option, value, description)->type_name(type);
}

/// An option whose text `parse` reads into `value`. An InputError of `parse` is reported with the option's name.
template <typename Value, typename Parse>
CLI::Option *add_parsed(CLI::App &command, const std::string &option, const std::string &type, Value &value,
                        Parse parse, const std::string &description) {
    const auto read = [&value, parse, option](const std::string &text) {
        value = with_flag(option, [&] { return parse(text); });
    };
    return command.add_option_function<std::string>(option, read, description)->type_name(type);
}

/// An option that takes one of `words`.
CLI::Option *add_choice(CLI::App &command, const std::string &option, const std::vector<std::string> &words,
                        std::string &value, const std::string &description);

/// --lang en|zh.
CLI::Option *add_language(CLI::App &command, std::string &language, const std::string &description);

/// Has `work` run after the command's options are read.
template <typename Flags>
void run_when_chosen(CLI::App &command, CommonOptions &common, Run &run, std::shared_ptr<Flags> flags,
                     int (*work)(const Flags &, const CommonOptions &)) {
    command.callback([=, &common, &run] { run = [=, &common] { return work(*flags, common); }; });
}

} // namespace sandbox
