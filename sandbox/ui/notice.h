#pragma once

#include <string>

namespace sandbox {

/// A brief message over the pictures, seen also where the panels are hidden. Times are a host's seconds.
class Notice {
  public:
    void say(std::string text, double now);
    void clear() { text_.clear(); }
    [[nodiscard]] bool shown() const { return !text_.empty(); }
    /// How much longer it stands; infinite if there is none.
    [[nodiscard]] double seconds_left(double now) const;
    /// Within a frame of Dear ImGui.
    void draw() const;

  private:
    std::string text_;
    double until_ = 0;
};

} // namespace sandbox
