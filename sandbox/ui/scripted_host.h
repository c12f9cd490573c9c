#pragma once

#include "render/target.h"
#include "ui/host.h"
#include "ui/script/script.h"

#include <optional>
#include <set>
#include <utility>

namespace sandbox {

/// A window in memory: no display server, frames are drawn into a texture. A script sets what mouse and keyboard do.
class ScriptedHost final : public Host {
  public:
    /// Throws MachineError where there is no OpenGL 3.3 through EGL.
    ScriptedHost(Size size, Profile profile);

    [[nodiscard]] Context &context() override { return *context_; }
    void begin_gui() override;
    void feed_gui() override;
    [[nodiscard]] KeysDown take_keys() override;
    [[nodiscard]] Arrivals take_arrivals() override { return std::exchange(arrivals_, {}); }
    [[nodiscard]] bool space_held() const override;
    [[nodiscard]] Size framebuffer_size() const override { return surface_->size(); }
    [[nodiscard]] unsigned framebuffer() const override { return surface_->framebuffer(); }
    [[nodiscard]] float content_scale() const override { return content_scale_; }
    [[nodiscard]] double seconds() const override { return seconds_; }
    void present() override {}

    void resize(Size size);
    /// As on a denser screen.
    void set_content_scale(float scale);
    /// The last frame.
    [[nodiscard]] ByteImage picture() const;

    // What the next frame sees.
    void wake() { arrivals_.any = true; }
    void move_mouse(float x, float y);
    enum class Button { left, right, middle };
    void press(Button button, bool down);
    void turn_wheel(float notches);
    /// Also sends the key to the window's own keys.
    void press_key(const KeyChord &chord);
    /// A modifier that stays down, or Space.
    void hold_key(int key, bool down);
    void release_keys() { pressed_.clear(); }
    void type(const std::string &text);
    void drop(const std::string &path);
    static constexpr float frame_time = 0.1F;
    /// Between two frames, for Dear ImGui's double clicks.
    void set_frame_time(float seconds) { frame_seconds_ = seconds; }

  private:
    std::unique_ptr<Context> context_;
    std::optional<DisplayTexture> surface_;
    Arrivals arrivals_;
    float mouse_x_ = -1, mouse_y_ = -1, wheel_ = 0;
    bool buttons_[3] = {false, false, false};
    std::set<int> held_, pressed_; ///< GLFW's keys: until released; for one frame
    int mods_ = 0;                 ///< of the key that is pressed
    std::string typed_;
    float content_scale_ = 1;
    float frame_seconds_ = frame_time;
    double seconds_ = 0; ///< of all frames
};

} // namespace sandbox
