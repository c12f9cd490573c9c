#include "ui/script_player.h"

#include "image/error.h"
#include "image/image_file.h"
#include "image/number.h"
#include "image/picture_size.h"
#include "image/thread.h"
#include "render/gl_state.h"
#include "ui/actions.h"
#include "ui/text_faults.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <fstream>
#include <random>
#include <utility>

namespace sandbox {

namespace {

using Player = ScriptPlayer;
constexpr ScriptAction rows[] = {
    {"click", "WIDGET [X Y]", "by its name, or X, Y pixels from its upper left corner", 1, 3, &Player::click},
    {"double-click", "WIDGET", "brings a camera back", 1, 1, &Player::double_click},
    {"right-click", "WIDGET", "resets a slider", 1, 1, &Player::right_click},
    {"drag", "WIDGET VALUE | WIDGET DX DY [STEPS]", "a slider to a value; anything by pixels", 2, 4, &Player::drag},
    {"hover", "WIDGET [X Y]", "moves the mouse there", 1, 3, &Player::hover},
    {"wheel", "WIDGET NOTCHES", "turns the wheel over it", 2, 2, &Player::wheel},
    {"type", "WIDGET TEXT", "into a field or a slider, then Enter", 2, 2, &Player::type},
    {"key", "KEY", "such as F12, Ctrl+Z, ?", 1, 1, &Player::key},
    {"hold", "KEY", "until it is released: Space, Shift, Ctrl, Alt", 1, 1, &Player::hold},
    {"release", "KEY", "", 1, 1, &Player::release},
    {"drop", "FILE", "drops a file on the window", 1, 1, &Player::drop},
    {"size", "WxH", "resizes the window", 1, 1, &Player::size},
    {"scale", "FACTOR", "the screen's own magnification: 2 on a dense one", 1, 1, &Player::scale},
    {"wait", "[SECONDS]", "until nothing is pending; at most so long", 0, 1, &Player::wait},
    {"play", "MOMENTS", "a motion that plays goes on by so many moments, and by none without this", 1, 1,
     &Player::play_moments},
    {"expect", "WIDGET TEXT", "nothing is pending and its text holds TEXT, or exit 1", 2, 2, &Player::expect},
    {"texts", "", "no text is cut off by its window or lies over another, or exit 1", 0, 0, &Player::texts},
    {"shot", "FILE.png", "the window, when nothing is pending", 1, 1, &Player::shot},
    {"list", "[START]", "prints the names of the widgets, and what they show", 0, 1, &Player::list},
    {"longest", "", "prints the CPU time of the window's longest frame since the last such line", 0, 0,
     &Player::longest},
    {"monkey", "COUNT SEED", "random actions; checks OpenGL's errors, prints the memory in use", 2, 2, &Player::monkey},
};

/// Of this thread alone: what keeps the window waiting, jobs apart.
double cpu_milliseconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

double number(const std::string &word) {
    double value = 0;
    const char *const end = word.data() + word.size();
    const auto [read_to, error] = read_number(word.data(), end, value);
    if (error != std::errc() || read_to != end || !std::isfinite(value)) {
        throw InputError("expected a number, got '{}'", word);
    }
    return value;
}

float pixels(const std::string &word) { return static_cast<float>(number(word)); }

/// What a person who mistyped a name may have meant: names with the same end, then those of the same place.
std::string likely_names(const WidgetMap &widgets, const std::string &wrong) {
    const auto slash = wrong.rfind('/');
    const std::string end = slash == std::string::npos ? wrong : wrong.substr(slash + 1);
    const std::string start = slash == std::string::npos ? "" : wrong.substr(0, slash + 1);
    std::vector<std::string> names;
    for (const bool by_end : {true, false}) {
        for (const auto &[name, widget] : widgets.all()) {
            const bool fits = by_end ? name.find(end) != std::string::npos : name.starts_with(start);
            if (fits && names.size() < 8 && std::ranges::find(names, name) == names.end()) {
                names.push_back(name);
            }
        }
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

} // namespace

std::span<const ScriptAction> script_actions() { return rows; }

const ScriptAction *find_action(std::string_view name) {
    const auto found = std::ranges::find(rows, name, &ScriptAction::name);
    return found == std::end(rows) ? nullptr : found;
}

ScriptPlayer::ScriptPlayer(Window &window, ScriptedHost &host) : window_(window), host_(host) {
    window_.session().widgets.listen();
    host_.wake();
    settle();
}

void ScriptPlayer::play(const ScriptLine &line) {
    (this->*find_action(line.words.front())->play)(Words(line.words).subspan(1));
}

void ScriptPlayer::frame() {
    const double start = cpu_milliseconds();
    window_.step();
    host_.release_keys();
    longest_ms_ = std::max(longest_ms_, cpu_milliseconds() - start);
}

void ScriptPlayer::step() {
    host_.wake();
    frame();
}

void ScriptPlayer::longest(Words /*words*/) {
    fmt::print("longest frame: {:.1f} ms of CPU\n", std::exchange(longest_ms_, 0));
}

/// Frames, until the window has answered all input.
void ScriptPlayer::settle() {
    do {
        frame();
    } while (window_.unsettled());
}

/// Until work in the background, too, has ended and is shown. Next to no time passes in the window: on a slow machine a
/// message would be gone before anyone could expect it.
void ScriptPlayer::finish() {
    settle();
    host_.set_frame_time(1e-4F);
    while (window_.busy()) {
        rest();
        settle();
    }
    host_.set_frame_time(ScriptedHost::frame_time);
}

/// Scrolled into view if need be.
const Widget &ScriptPlayer::widget(const std::string &name) {
    WidgetMap &widgets = window_.session().widgets;
    const Widget *found = widgets.find(name);
    if (found == nullptr || !found->visible()) {
        widgets.want(name);
        step();
        settle();
        widgets.want("");
        found = widgets.find(name);
    }
    if (found == nullptr) {
        throw InputError("there is no widget '{}' here; perhaps: {}", name, likely_names(widgets, name));
    }
    if (!found->visible()) {
        throw InputError("the widget '{}' cannot be seen", name);
    }
    return *found;
}

/// NAME, or NAME X Y.
ScriptPlayer::Point ScriptPlayer::place(Words words) {
    const Widget found = widget(words[0]);
    if (words.size() == 2) {
        throw InputError("expected WIDGET or WIDGET X Y");
    }
    if (words.size() == 3) {
        return {found.left + pixels(words[1]) + 0.5F, found.top + pixels(words[2]) + 0.5F};
    }
    return {std::floor((found.left + found.right) / 2), std::floor((found.top + found.bottom) / 2)};
}

void ScriptPlayer::press_at(Point at, ScriptedHost::Button button, int times) {
    host_.move_mouse(at.x, at.y);
    settle();
    host_.set_frame_time(times > 1 ? 0.01F : ScriptedHost::frame_time); // within or beyond the time of a double click
    for (int i = 0; i < times; ++i) {
        host_.press(button, true);
        step();
        host_.press(button, false);
        step();
    }
    host_.set_frame_time(ScriptedHost::frame_time);
    settle();
}

void ScriptPlayer::click(Words words) { press_at(place(words), ScriptedHost::Button::left, 1); }
void ScriptPlayer::double_click(Words words) { press_at(place(words), ScriptedHost::Button::left, 2); }
void ScriptPlayer::right_click(Words words) { press_at(place(words), ScriptedHost::Button::right, 1); }

void ScriptPlayer::drag_by(Point from, float x, float y, int steps) {
    host_.move_mouse(from.x, from.y);
    settle();
    host_.press(ScriptedHost::Button::left, true);
    step();
    for (int i = 1; i <= steps; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(steps);
        host_.move_mouse(from.x + x * share, from.y + y * share);
        step();
    }
    host_.press(ScriptedHost::Button::left, false);
    step();
    settle();
}

/// Whatever the slider's scale: holds it, and halves the pixels between too little and too much.
void ScriptPlayer::drag_to_value(const std::string &name, double value) {
    const Point from = place(Words(&name, 1));
    if (!widget(name).value) {
        throw InputError("'{}' is no slider: expected DX DY, in pixels", name);
    }
    const auto at = [&](float x) {
        host_.move_mouse(x, from.y);
        step();
        step();
        return widget(name).value.value_or(value);
    };
    host_.move_mouse(from.x, from.y);
    settle();
    host_.press(ScriptedHost::Button::left, true);
    step();
    float low = from.x, high = from.x;
    constexpr float farthest = 16384;
    const float direction = at(from.x) < value ? 1 : -1;
    for (float reach = 16; reach < farthest && (at(high) - value) * static_cast<double>(direction) < 0; reach *= 2) {
        low = high;
        high = from.x + direction * reach;
    }
    while (std::abs(high - low) > 1) {
        const float middle = std::floor((low + high) / 2);
        ((at(middle) - value) * static_cast<double>(direction) < 0 ? low : high) = middle;
    }
    const bool low_is_nearer = std::abs(at(low) - value) < std::abs(at(high) - value);
    at(low_is_nearer ? low : high);
    host_.press(ScriptedHost::Button::left, false);
    step();
    settle();
}

void ScriptPlayer::drag(Words words) {
    if (words.size() == 2) {
        return drag_to_value(words[0], number(words[1]));
    }
    const double steps = words.size() > 3 ? number(words[3]) : drag_steps;
    if (!(steps >= 1 && steps <= 10000)) {
        throw InputError("expected 1 to 10000 steps, got {}", words[3]);
    }
    drag_by(place(words.first(1)), pixels(words[1]), pixels(words[2]), static_cast<int>(steps));
}

void ScriptPlayer::hover(Words words) {
    const Point at = place(words);
    host_.move_mouse(at.x, at.y);
    settle();
}

void ScriptPlayer::wheel(Words words) {
    hover(words.first(1));
    host_.turn_wheel(pixels(words[1]));
    settle();
}

void ScriptPlayer::type(Words words) {
    const bool slider = widget(words[0]).value.has_value();
    host_.hold_key(GLFW_KEY_LEFT_CONTROL, slider); // Ctrl+click takes a number
    press_at(place(words.first(1)), ScriptedHost::Button::left, 1);
    host_.hold_key(GLFW_KEY_LEFT_CONTROL, false);
    key(std::vector<std::string>{"Ctrl+A"});
    host_.type(words[1]);
    step();
    key(std::vector<std::string>{"Enter"});
}

void ScriptPlayer::key(Words words) {
    host_.press_key(parse_key(words[0]));
    step();
    settle();
}

void ScriptPlayer::hold(Words words) {
    host_.hold_key(parse_key(words[0]).key, true);
    settle();
}

void ScriptPlayer::release(Words words) {
    host_.hold_key(parse_key(words[0]).key, false);
    settle();
}

void ScriptPlayer::drop(Words words) {
    host_.drop(words[0]);
    settle();
}

void ScriptPlayer::size(Words words) {
    host_.resize(parse_size(words[0]));
    settle();
}

void ScriptPlayer::scale(Words words) {
    const double factor = number(words[0]);
    if (!(factor >= 0.5 && factor <= 4)) {
        throw InputError("expected a scale from 0.5 to 4, got {}", words[0]);
    }
    host_.set_content_scale(static_cast<float>(factor));
    settle();
}

void ScriptPlayer::wait(Words words) {
    if (words.empty()) {
        return finish();
    }
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(number(words[0]));
    while (std::chrono::steady_clock::now() < end && (window_.busy() || window_.unsettled())) {
        rest();
        settle();
    }
}

void ScriptPlayer::play_moments(Words words) {
    for (auto left = static_cast<int>(number(words[0])); left > 0; --left) {
        window_.play_moment();
        settle();
    }
    host_.wake();
    settle();
}

void ScriptPlayer::expect(Words words) {
    finish();
    const std::string text = widget(words[0]).text;
    if (text.find(words[1]) == std::string::npos) {
        throw ExpectationFailed(fmt::format("expected '{}' to show '{}', it shows '{}'", words[0], words[1], text));
    }
}

void ScriptPlayer::texts(Words /*words*/) {
    finish();
    if (const std::vector<std::string> faults = text_faults(); !faults.empty()) {
        throw ExpectationFailed(fmt::format("{}", fmt::join(faults, "; ")));
    }
}

void ScriptPlayer::shot(Words words) {
    finish();
    write_file(words[0], encode_png(host_.picture()));
}

void ScriptPlayer::list(Words words) {
    finish();
    for (const auto &[name, widget] : window_.session().widgets.all()) {
        if (words.empty() || name.starts_with(words[0])) {
            fmt::print("{}{}{}\n", name, widget.text == name || widget.text.empty() ? "" : "\t", widget.text);
        }
    }
}

/// One click, drag, turn of the wheel or key; none that writes files or ends the window.
void ScriptPlayer::random_action(unsigned dice) {
    Session &session = window_.session();
    const auto pick = [&](const auto &list) { return std::next(list.begin(), (dice >> 8) % std::size(list)); };
    const unsigned kind = dice % 8;
    if (kind == 0) {
        const Action &action = *pick(actions());
        if (action.key >= 0 && action.key != GLFW_KEY_Q && action.key != GLFW_KEY_F12) {
            host_.press_key({action.key, action.mods});
            step();
        }
        return settle();
    }
    std::vector<std::string> names;
    for (const auto &[name, widget] : session.widgets.all()) {
        if (widget.visible() && !name.ends_with("Export") && name.find("Capture") == std::string::npos &&
            !name.ends_with("captures") && !name.ends_with("quit")) {
            names.push_back(name);
        }
    }
    if (names.empty()) {
        return;
    }
    const std::string &name = *pick(names);
    const Point at = place(Words(&name, 1));
    const auto far = [&](unsigned shift) { return static_cast<float>((dice >> shift) % 201) - 100.0F; };
    if (kind == 1) {
        press_at(at, ScriptedHost::Button::right, 1);
    } else if (kind == 2) {
        host_.turn_wheel(far(12) / 50);
        settle();
    } else if (kind < 5) {
        drag_by(at, far(12), far(20));
    } else {
        press_at(at, ScriptedHost::Button::left, 1);
    }
}

namespace {

/// Of this process, in MB; 0 where the system does not say.
long resident_megabytes() {
    std::ifstream file("/proc/self/statm");
    long all = 0, resident = 0;
    file >> all >> resident;
    return resident * 4096 / 1000000;
}

} // namespace

void ScriptPlayer::monkey(Words words) {
    const auto count = static_cast<int>(number(words[0]));
    std::mt19937 dice(static_cast<unsigned>(number(words[1])));
    Session &session = window_.session();
    const Document first = session.document;
    const Appearance appearance = session.appearance;
    constexpr int reports = 10;
    for (int i = 1; i <= count; ++i) {
        random_action(static_cast<unsigned>(dice()));
        check_gl("work the window");
        session.requests.quit = false;
        if (i % std::max(count / reports, 1) == 0) { // always of the same scene, shown in the same way
            session.appearance = appearance;
            show_document(session, first);
            finish();
            fmt::print("{} actions, {} MB resident\n", i, resident_megabytes());
            std::fflush(stdout);
        }
    }
}

} // namespace sandbox
