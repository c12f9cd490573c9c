#include "scene/scene_json.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

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

std::string print_json(const OrderedJson &json) {
    std::string out;
    print(json, 0, 0, out);
    return out + "\n";
}

} // namespace sandbox
