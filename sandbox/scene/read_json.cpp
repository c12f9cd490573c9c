#include "scene/read_json.h"

#include "image/error.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

namespace sandbox {
namespace {

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

/// At most `most` bytes, cut between two characters.
std::string shortened(std::string text, std::size_t most) {
    if (text.size() > most) {
        std::size_t end = most - 3;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) {
            --end;
        }
        text.replace(end, std::string::npos, "...");
    }
    return text;
}

/// The library's message without its own numbering: from "...: syntax error ..." on.
std::string plain_message(const std::string &what) {
    constexpr std::size_t most = 300; // it repeats the whole of a word, however long
    for (const std::string_view before : {"syntax error ", "column "}) {
        if (const std::size_t at = what.find(before); at != std::string::npos) {
            const std::size_t from = before == "column " ? what.find(": ", at) + 2 : at;
            return shortened(what.substr(from), most);
        }
    }
    return shortened(what.substr(what.find("] ") + 2), most);
}

/// Builds the value from the parser's events. The library's own builder looks through all earlier keys of an
/// ordered_json for each key, and with a callback through all earlier elements of an array for each element.
template <class Json> class Builder {
  public:
    using number_integer_t = typename Json::number_integer_t;
    using number_unsigned_t = typename Json::number_unsigned_t;
    using number_float_t = typename Json::number_float_t;
    using string_t = typename Json::string_t;
    using binary_t = typename Json::binary_t;

    Builder(std::string_view text, std::string_view name) : text_(text), name_(name) {}

    bool null() { return add(nullptr); }
    bool boolean(bool value) { return add(value); }
    bool number_integer(number_integer_t value) { return add(value); }
    bool number_unsigned(number_unsigned_t value) { return add(value); }
    bool number_float(number_float_t value, const string_t &) { return add(value); }
    bool string(string_t &value) { return add(std::move(value)); }
    bool binary(binary_t &) { return false; } // text has none
    bool start_object(std::size_t) { return open(Json::object()); }
    bool start_array(std::size_t) { return open(Json::array()); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    bool key(string_t &key) {
        Level &level = levels_.back();
        level.key = std::move(key);
        if (!level.keys.insert(level.key).second) {
            throw InputError("{}: {}: this key is given twice", name_, path());
        }
        return true;
    }

    bool parse_error(std::size_t byte, const std::string &, const typename Json::exception &error) {
        if (dynamic_cast<const typename Json::parse_error *>(&error) == nullptr) { // a number such as 1e999
            if (!levels_.empty() && levels_.back().json->is_array()) {
                levels_.back().json->push_back(nullptr); // the path names it
            }
            throw InputError("{}: {}: expected a finite number: {}", name_, path(), plain_message(error.what()));
        }
        const std::string message = plain_message(error.what());
        const bool no_literal = message.find("invalid literal") != std::string::npos;
        throw InputError("{}:{}: {}{}{}", name_, line_and_column(text_, byte),
                         message.starts_with("syntax error") ? "" : "syntax error: ", message,
                         no_literal ? "; expected a finite number, a string, true or false (JSON has no NaN)" : "");
    }

    Json take() { return std::move(built_); }

  private:
    struct Level {
        Json *json;
        std::string key; ///< the last
        std::set<std::string> keys;
    };
    std::string_view text_;
    std::string_view name_;
    Json built_;
    std::vector<Level> levels_;
    std::size_t values_ = 0;

    [[nodiscard]] std::string path() const {
        std::string out;
        for (const Level &level : levels_) {
            out += level.json->is_array() ? fmt::format("[{}]", std::max<std::size_t>(level.json->size(), 1) - 1)
                                          : (out.empty() ? "" : ".") + shortened(level.key, 60);
        }
        return out;
    }

    Json *place(Json value) {
        if (++values_ > most_json_values) {
            throw InputError("{}: expected at most {} values, got more", name_, most_json_values);
        }
        if (levels_.empty()) {
            built_ = std::move(value);
            return &built_;
        }
        Level &level = levels_.back();
        if (level.json->is_array()) {
            level.json->push_back(std::move(value));
            return &level.json->back();
        }
        // Known to be a new key: at the end, where a map that keeps order has it without a search.
        auto &object = level.json->template get_ref<typename Json::object_t &>();
        if constexpr (requires { object.emplace_back(level.key, std::move(value)); }) {
            return &object.emplace_back(level.key, std::move(value)).second;
        } else {
            return &object.emplace(level.key, std::move(value)).first->second;
        }
    }
    bool add(Json value) {
        place(std::move(value));
        return true;
    }
    bool open(Json value) {
        if (levels_.size() == deepest_json) {
            throw InputError("{}: nested deeper than {} levels", name_, deepest_json);
        }
        Json *json = place(std::move(value));
        levels_.push_back({json, {}, {}});
        return true;
    }
    bool close() {
        levels_.pop_back();
        return true;
    }
};

/// Line ends and tabs between values, where there are very many, as spaces: the library's message of what it read last
/// has eight characters for each, and copies of that.
std::string with_spaces(std::string_view text) {
    std::string out(text);
    bool in_string = false;
    for (std::size_t i = 0; i < out.size(); ++i) {
        if (in_string && out[i] == '\\') {
            ++i;
        } else if (out[i] == '"') {
            in_string = !in_string;
        } else if (!in_string && (out[i] == '\n' || out[i] == '\r' || out[i] == '\t')) {
            out[i] = ' ';
        }
    }
    return out;
}

} // namespace

template <class Json> Json read_json(std::string_view text, std::string_view name) {
    if (text.size() > largest_json) {
        throw InputError("{}: the file is larger than {} MiB", name, largest_json >> 20);
    }
    constexpr std::ptrdiff_t many = 1000000;
    const auto line_ends = std::ranges::count_if(text, [](char c) { return c == '\n' || c == '\r' || c == '\t'; });
    Builder<Json> builder(text, name);
    if (line_ends > many) {
        Json::sax_parse(with_spaces(text), &builder);
    } else {
        Json::sax_parse(text, &builder);
    }
    return builder.take();
}

template <class Json> std::string short_json(const Json &json) {
    constexpr std::size_t most = 60;
    if (json.is_array() && json.size() > most) {
        return fmt::format("an array of {}", json.size());
    }
    const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return json.is_array() && text.size() > most ? fmt::format("an array of {}", json.size()) : shortened(text, most);
}

bool begins_object(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) {
        text.remove_prefix(3);
    }
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && text[first] == '{';
}

template nlohmann::json read_json(std::string_view text, std::string_view name);
template nlohmann::ordered_json read_json(std::string_view text, std::string_view name);
template std::string short_json(const nlohmann::json &json);
template std::string short_json(const nlohmann::ordered_json &json);

} // namespace sandbox
