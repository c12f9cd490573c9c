#pragma once

#include "ui/script/script.h"
#include "ui/scripted_host.h"
#include "ui/window.h"

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace sandbox {

/// An `expect` that was not met.
class ExpectationFailed : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Plays the lines of a script on a window. Throws InputError for a widget or a number that makes no sense.
class ScriptPlayer {
  public:
    ScriptPlayer(Window &window, ScriptedHost &host);
    /// The line must be one that find_action() knows, with as many words as it takes.
    void play(const ScriptLine &line);

    using Words = std::span<const std::string>;
    void click(Words words);
    void double_click(Words words);
    void right_click(Words words);
    void drag(Words words);
    void hover(Words words);
    void wheel(Words words);
    void type(Words words);
    void key(Words words);
    void hold(Words words);
    void release(Words words);
    void drop(Words words);
    void size(Words words);
    void scale(Words words);
    void wait(Words words);
    void play_moments(Words words);
    void expect(Words words);
    void texts(Words words);
    void shot(Words words);
    void list(Words words);
    void longest(Words words);
    void monkey(Words words);

  private:
    struct Point {
        float x = 0, y = 0;
    };
    [[nodiscard]] const Widget &widget(const std::string &name);
    [[nodiscard]] Point place(Words words);
    void frame();
    void step();
    void settle();
    void finish();
    void press_at(Point at, ScriptedHost::Button button, int times);
    static constexpr int drag_steps = 8;
    void drag_by(Point from, float x, float y, int steps = drag_steps);
    void drag_to_value(const std::string &name, double value);
    void random_action(unsigned dice);

    Window &window_;
    ScriptedHost &host_;
    double longest_ms_ = 0; ///< of CPU, a frame
};

/// A row of what a script may say.
struct ScriptAction {
    std::string_view name, takes, help;
    std::size_t fewest, most; ///< words after the name
    void (ScriptPlayer::*play)(ScriptPlayer::Words);
};
std::span<const ScriptAction> script_actions();
/// Null: there is none.
const ScriptAction *find_action(std::string_view name);

} // namespace sandbox
