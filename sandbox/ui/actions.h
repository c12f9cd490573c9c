#pragma once

#include "ui/session/session.h"

#include <functional>
#include <span>
#include <string>

namespace sandbox {

/// What a key, a menu item or a button of the menu bar does: all of them, and the list of keys, read these rows.
struct Action {
    enum class Group { key_only, layout, edit, lesson, window }; ///< layout: buttons; the last three: menus

    Group group;
    int mods, key;                                        ///< GLFW's; key -1: none
    std::string shown;                                    ///< the key, as lists show it; empty: not listed
    std::function<std::string(const Words &)> name, help; ///< help may be none
    std::function<void(Session &)> run;
    std::function<bool(const Session &)> is_on{};      ///< pressed or ticked
    std::function<bool(const Session &)> is_usable{};  ///< none: always
    bool repeats = false;                              ///< while the key is held
    std::function<std::string(const Words &)> brief{}; ///< of a layout: its name where there is little room
};
std::span<const Action> actions();
Label label_of(const Session &session, const Action &action);
/// Empty: there is none.
std::string help_of(const Session &session, const Action &action);

} // namespace sandbox
