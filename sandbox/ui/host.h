#pragma once

#include "image/image.h"
#include "render/context.h"
#include "ui/keyboard.h"

#include <memory>
#include <string>
#include <vector>

namespace sandbox {

/// A key as pressed: GLFW's names, after the keyboard's layout.
struct KeyPress {
    int key = 0, mods = 0;
    bool repeated = false;
};

/// Input since the last take_arrivals().
struct Arrivals {
    bool any = false;     ///< anything at all that may change the picture
    bool exposed = false; ///< what was shown may be lost
    std::vector<KeyPress> keys;
    std::string typed; ///< text, as UTF-8
    bool question_mark = false;
    std::vector<std::string> dropped; ///< paths
};

/// What the window stands on: the operating system's window, or a picture in memory that a script works.
class Host {
  public:
    Host() = default;
    virtual ~Host() = default;
    Host(const Host &) = delete;
    Host &operator=(const Host &) = delete;

    [[nodiscard]] virtual Context &context() = 0;
    /// Around the life of Dear ImGui's context.
    virtual void begin_gui() = 0;
    virtual void end_gui() {}
    /// Dear ImGui's input of the frame that begins, but for its keys.
    virtual void feed_gui() = 0;
    /// The keys that are down in the frame that begins.
    [[nodiscard]] virtual KeysDown take_keys() = 0;
    [[nodiscard]] virtual Arrivals take_arrivals() = 0;
    [[nodiscard]] virtual bool space_held() const = 0;
    /// Physical pixels; (0, 0) while minimised.
    [[nodiscard]] virtual Size framebuffer_size() const = 0;
    /// The framebuffer object that frames are drawn into.
    [[nodiscard]] virtual unsigned framebuffer() const { return 0; }
    /// The screen's own magnification: 2 on a dense one.
    [[nodiscard]] virtual float content_scale() const { return 1; }
    /// Since some moment; a script's clock goes on with its frames.
    [[nodiscard]] virtual double seconds() const = 0;
    /// Shows the frame that has been drawn.
    virtual void present() = 0;
    virtual void set_title(const std::string &) {}
    virtual void set_full_screen(bool) {}
    /// Lets the user choose a file, which then arrives as if it had been dropped; false: the window has to ask.
    virtual bool pick_file() { return false; }
    /// Gives the user a link that opens `state`, a sidecar's text.
    virtual void share(const std::string & /*state*/) {}
    /// Says what else is inside, and under which licences.
    virtual void show_licences() {}
};

} // namespace sandbox
