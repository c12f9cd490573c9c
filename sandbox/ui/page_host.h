#pragma once

#include "ui/host.h"

#include <deque>
#include <string>
#include <utility>

namespace sandbox {

/// A page's canvas, which fills it; mouse, fingers and keyboard as sandbox/page/browser.js hands them over.
class PageHost final : public Host {
  public:
    /// Throws MachineError, which says what to try, if the browser has no WebGL 2.
    PageHost();

    [[nodiscard]] Context &context() override { return *context_; }
    void begin_gui() override;
    void feed_gui() override;
    [[nodiscard]] KeysDown take_keys() override;
    [[nodiscard]] Arrivals take_arrivals() override;
    [[nodiscard]] bool space_held() const override;
    [[nodiscard]] Size framebuffer_size() const override { return size_; }
    [[nodiscard]] float content_scale() const override { return scale_; }
    [[nodiscard]] double seconds() const override;
    void present() override {} // the browser shows what has been drawn
    void set_title(const std::string &title) override;
    void set_full_screen(bool on) override;
    bool pick_file() override;
    void share(const std::string &state) override;
    void show_licences() override;

    // What the page hands over.
    void resize(Size size, float scale);
    /// In physical pixels; `buttons` as DOM has them: 1 left, 2 right, 4 middle.
    void move_pointer(float x, float y, int buttons);
    /// A finger has left: there is no pointer any more.
    void lift_pointer();
    void turn_wheel(float notches);
    /// GLFW's names, after the keyboard's layout.
    void press_key(int key, int mods, bool down, bool repeated);
    void type(const std::string &text);
    void drop(const std::string &path);
    void paste(const std::string &text) { clipboard_ = text; }
    /// Keys that are held no longer, what was shown may be lost.
    void change_focus();

  private:
    struct Pointer {
        float x, y;
        int buttons;
    };
    void wake();
    static const char *clipboard(void *host);

    std::unique_ptr<Context> context_;
    Arrivals arrivals_;
    Size size_;
    float scale_ = 1;
    std::deque<Pointer> pointers_; ///< to be seen, one press or release a frame: a tap may be shorter than one
    float wheel_ = 0;
    Keyboard keyboard_;
    int mods_ = 0;
    std::string typed_, clipboard_;
    double last_frame_ = 0;
    bool full_screen_ = false, wants_text_ = false;
};

} // namespace sandbox
