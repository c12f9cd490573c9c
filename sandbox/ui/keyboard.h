#pragma once

#include <map>
#include <set>
#include <utility>

namespace sandbox {

/// What is down in a frame: GLFW's names, after the keyboard's layout; `mods` as GLFW_MOD_CONTROL and its like.
struct KeysDown {
    std::set<int> keys;
    int mods = 0;
};

/// What a person holds, and tapped since the last frame: a tap may be shorter than one.
class Keyboard {
  public:
    /// `place` is the key's own, which stays when the layout changes while it is down.
    void press(int place, int key, int mods) {
        held_[place] = key;
        tapped_.keys.insert(key);
        tapped_.mods |= mods;
    }
    void release(int place) { held_.erase(place); }
    void release_all() { held_.clear(); }
    [[nodiscard]] bool holds(int place) const { return held_.contains(place); }
    [[nodiscard]] bool tapped() const { return !tapped_.keys.empty(); }

    /// For the frame that begins; `held_mods` are down anyway.
    [[nodiscard]] KeysDown take(int held_mods) {
        for (const auto &[place, key] : held_) {
            tapped_.keys.insert(key);
        }
        tapped_.mods |= held_mods;
        return std::exchange(tapped_, {});
    }

  private:
    std::map<int, int> held_; ///< keys by their places
    KeysDown tapped_;
};

} // namespace sandbox
