#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sandbox {

/// A control or a line of text, as last drawn.
struct Widget {
    float left = 0, top = 0, right = 0, bottom = 0; ///< what can be seen of it, in ImGui's coordinates; empty: nothing
    std::string text;                               ///< what it shows
    std::optional<double> value;                    ///< of a slider
    [[nodiscard]] bool visible() const { return right > left && bottom > top; }
};

/// The widgets of a frame by name, for scripts: "Technique/A/per-pixel", "Lights/1/diffuse". Names are those that the
/// window and the commands show. Nothing is kept unless somebody listens.
class WidgetMap {
  public:
    void listen() { listening_ = true; }
    [[nodiscard]] bool listening() const { return listening_; }
    /// The last frame's widgets become those that find() sees.
    void begin_frame();
    /// The names of widgets added until leave() begin with `name` and a slash.
    void enter(std::string_view name) { scopes_.emplace_back(name); }
    void leave() { scopes_.pop_back(); }
    /// The first of a name counts.
    void add(std::string_view name, Widget widget);
    /// Null: there is none of this name.
    [[nodiscard]] const Widget *find(const std::string &name) const;
    [[nodiscard]] const std::map<std::string, Widget> &all() const { return shown_; }

    /// A widget of this name is scrolled into view when it is drawn.
    void want(std::string name) { wanted_ = std::move(name); }
    [[nodiscard]] bool wanted(std::string_view name) const { return listening_ && full_name(name) == wanted_; }

  private:
    [[nodiscard]] std::string full_name(std::string_view name) const;

    bool listening_ = false;
    std::vector<std::string> scopes_;
    std::map<std::string, Widget> shown_, drawn_; ///< of the last frame, of this one
    std::string wanted_;
};

} // namespace sandbox
