#include "scene/scene_json.h"

#include "image/error.h"

#include <nlohmann/json.hpp>
#include <set>
#include <vector>

namespace sandbox {
namespace {

constexpr std::size_t largest_text = std::size_t{16} << 20;
constexpr std::size_t deepest = 64;

/// `line:column` of a byte, both from 1; a column is a character, not a byte of one.
std::string line_and_column(std::string_view text, std::size_t byte) {
    std::size_t line = 1;
    std::size_t column = 1;
    for (const char c : text.substr(0, byte > 0 ? byte - 1 : 0)) {
        if (c == '\n') {
            ++line;
            column = 1;
        } else if ((static_cast<unsigned char>(c) & 0xc0U) != 0x80U) {
            ++column;
        }
    }
    return std::to_string(line) + ":" + std::to_string(column);
}

/// The library's message without its own numbering: from "...: syntax error ..." on.
std::string plain_message(const std::string &what) {
    for (const std::string_view before : {"syntax error ", "column "}) {
        if (const std::size_t at = what.find(before); at != std::string::npos) {
            const std::size_t from = before == "column " ? what.find(": ", at) + 2 : at;
            return what.substr(from);
        }
    }
    return what.substr(what.find("] ") + 2);
}

/// Follows the parser through the text, to know the path of what is read and to refuse keys given twice.
class Tracker {
  public:
    explicit Tracker(std::string_view name) : name_(name) {}

    void on(Json::parse_event_t event, const Json &parsed) {
        using Event = Json::parse_event_t;
        switch (event) {
        case Event::object_start:
        case Event::array_start:
            count_element();
            levels_.push_back({event == Event::array_start, 0, {}, {}});
            if (levels_.size() > deepest) {
                throw InputError(name_ + ": nested deeper than " + std::to_string(deepest) + " levels");
            }
            break;
        case Event::object_end:
        case Event::array_end:
            levels_.pop_back();
            break;
        case Event::key:
            levels_.back().key = parsed.get_ref<const std::string &>();
            if (!levels_.back().keys.insert(levels_.back().key).second) {
                throw InputError(name_ + ": " + path() + ": this key is given twice");
            }
            break;
        case Event::value:
            count_element();
            break;
        }
    }

    [[nodiscard]] std::string path() const {
        std::string out;
        for (const Level &level : levels_) {
            out += level.array ? "[" + std::to_string(level.count - (level.count > 0 ? 1 : 0)) + "]"
                               : (out.empty() ? "" : ".") + level.key;
        }
        return out;
    }

    /// For a value that was refused before it was counted.
    void count_element() {
        if (!levels_.empty() && levels_.back().array) {
            ++levels_.back().count;
        }
    }

  private:
    struct Level {
        bool array;
        std::size_t count;
        std::string key;
        std::set<std::string> keys;
    };
    std::string name_;
    std::vector<Level> levels_;
};

} // namespace

Json parse_json(std::string_view text, std::string_view name) {
    const std::string file(name);
    if (text.size() > largest_text) {
        throw InputError(file + ": the file is larger than 16 MiB");
    }
    Tracker tracker(name);
    const auto follow = [&](int, Json::parse_event_t event, const Json &parsed) {
        tracker.on(event, parsed);
        return true;
    };
    try {
        return Json::parse(text, follow);
    } catch (const Json::parse_error &error) {
        const std::string message = plain_message(error.what());
        const bool no_literal = message.find("invalid literal") != std::string::npos;
        throw InputError(file + ":" + line_and_column(text, error.byte) + ": " + message +
                         (no_literal ? "; expected a finite number, a string, true or false (JSON has no NaN)" : ""));
    } catch (const Json::exception &error) { // a number such as 1e999
        tracker.count_element();
        throw InputError(file + ": " + tracker.path() + ": expected a finite number: " + plain_message(error.what()));
    }
}

} // namespace sandbox
