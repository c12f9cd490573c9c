#include "scene/scene_json.h"

#include "image/error.h"

#include <cmath>
#include <fmt/format.h>
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
    return fmt::format("{}:{}", line, column);
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

/// Follows the parser through the text: knows the path of what is read, and refuses a key that is given twice.
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
                throw InputError("{}: nested deeper than {} levels", name_, deepest);
            }
            break;
        case Event::object_end:
        case Event::array_end:
            levels_.pop_back();
            break;
        case Event::key:
            levels_.back().key = parsed.get_ref<const std::string &>();
            if (!levels_.back().keys.insert(levels_.back().key).second) {
                throw InputError("{}: {}: this key is given twice", name_, path());
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
            out += level.array ? fmt::format("[{}]", level.count - (level.count > 0 ? 1 : 0))
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

constexpr std::size_t line_length = 100;

/// The shortest text that reads back as the same value; invalid UTF-8 (a file name, say) must not stop a save.
std::string scalar(const OrderedJson &json) {
    if (json.is_number_float()) {
        const double value = json.get<double>();
        if (std::abs(value) < 1e15 && value == std::trunc(value) && !(value == 0 && std::signbit(value))) {
            return fmt::format("{}", static_cast<long long>(value));
        }
    }
    return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

std::string one_line(const OrderedJson &json) {
    if (!json.is_structured()) {
        return scalar(json);
    }
    std::string out;
    for (const auto &[key, value] : json.items()) {
        out += out.empty() ? "" : ", ";
        out += json.is_object() ? scalar(key) + ": " + one_line(value) : one_line(value);
    }
    return json.is_object() ? "{" + out + "}" : "[" + out + "]";
}

void print(const OrderedJson &json, std::size_t indent, std::size_t column, std::string &out) {
    const std::string compact = one_line(json);
    if (!json.is_structured() || json.empty() || (indent > 0 && column + compact.size() < line_length)) {
        out += compact;
        return;
    }
    out += json.is_object() ? "{" : "[";
    const std::string margin(indent + 2, ' ');
    bool first = true;
    for (const auto &[key, value] : json.items()) {
        out += (first ? "\n" : ",\n") + margin;
        first = false;
        const std::string label = json.is_object() ? scalar(key) + ": " : "";
        out += label;
        print(value, indent + 2, margin.size() + label.size(), out);
    }
    out += "\n" + std::string(indent, ' ') + (json.is_object() ? "}" : "]");
}

} // namespace

Json parse_json(std::string_view text, std::string_view name) {
    if (text.size() > largest_text) {
        throw InputError("{}: the file is larger than 16 MiB", name);
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
        throw InputError("{}:{}: {}{}", name, line_and_column(text, error.byte), message,
                         no_literal ? "; expected a finite number, a string, true or false (JSON has no NaN)" : "");
    } catch (const Json::exception &error) { // a number such as 1e999
        tracker.count_element();
        throw InputError("{}: {}: expected a finite number: {}", name, tracker.path(), plain_message(error.what()));
    }
}

std::string print_json(const OrderedJson &json) {
    std::string out;
    print(json, 0, 0, out);
    return out + "\n";
}

} // namespace sandbox
