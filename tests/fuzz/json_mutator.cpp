#include "fuzz/json_mutator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

namespace sandbox {
namespace {

using Json = nlohmann::ordered_json;
using Dice = std::minstd_rand;

std::size_t roll(Dice &dice, std::size_t sides) { return static_cast<std::size_t>(dice()) / 7 % sides; }
template <class Range> const auto &one_of(const Range &range, Dice &dice) {
    return *std::next(std::begin(range), static_cast<std::ptrdiff_t>(roll(dice, std::size(range))));
}

/// Ends of ranges and of types.
const std::vector<Json> &numbers() {
    static const std::vector<Json> all{0,
                                       -0.0,
                                       1,
                                       -1,
                                       2,
                                       3,
                                       0.5,
                                       -0.5,
                                       0.1,
                                       1.0 / 3,
                                       1e-6,
                                       1e-9,
                                       1e-30,
                                       1e-310,
                                       64,
                                       65,
                                       90,
                                       128,
                                       179,
                                       180,
                                       255,
                                       256,
                                       360,
                                       4096,
                                       8192,
                                       16384,
                                       100000,
                                       1000000,
                                       1000001,
                                       1e7,
                                       1e9,
                                       1.1e9,
                                       1e10,
                                       1e15,
                                       1e16,
                                       1e30,
                                       1e39,
                                       1e300,
                                       -1e9,
                                       -1e10,
                                       -1e300,
                                       32767,
                                       65535,
                                       2147483647,
                                       -2147483648LL,
                                       4294967295U,
                                       9007199254740993LL,
                                       1.7976931348623157e308,
                                       std::numeric_limits<std::uint64_t>::max(),
                                       std::numeric_limits<std::int64_t>::min()};
    return all;
}

const std::vector<Json> &oddities() {
    static const std::vector<Json> all{nullptr,
                                       true,
                                       false,
                                       "",
                                       "a",
                                       "\n",
                                       "\x1b[2J",
                                       "\xC3\xA9",
                                       "\xF0\x9F\x98\x80",
                                       "../a.png",
                                       "/dev/zero",
                                       "<script>",
                                       std::string(300, 'k'),
                                       Json::array(),
                                       Json::object(),
                                       Json::array({1, 2, 3}),
                                       Json::array({1, 2}),
                                       Json::array({0, 0, 0}),
                                       Json::object({{"en", "a"}, {"zh", "b"}})};
    return all;
}

std::optional<Json> parsed(std::string_view text) {
    Json json = Json::parse(text, nullptr, false);
    return json.is_discarded() ? std::nullopt : std::optional(std::move(json));
}

std::optional<std::string> printed(const Json &json, std::size_t most) {
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text.size() > most ? std::nullopt : std::optional(std::move(text));
}

} // namespace

JsonMutator::JsonMutator(const std::vector<std::string> &seeds) {
    for (const std::string &seed : seeds) {
        if (const auto json = parsed(seed)) {
            learn(*json);
        }
    }
    for (const auto &[key, values] : values_) {
        keys_.push_back(key);
    }
}

void JsonMutator::learn(const Json &json) {
    constexpr std::size_t most_of_a_key = 40, most_elements = 40, most_values = 2000;
    if (json.is_object()) {
        for (const auto &[key, value] : json.items()) {
            std::vector<Json> &known = values_[key];
            if (known.size() < most_of_a_key && value.size() < most_elements &&
                std::ranges::find(known, value) == known.end()) {
                known.push_back(value);
            }
        }
    }
    if (all_values_.size() < most_values && json.size() < most_elements) {
        all_values_.push_back(json);
    }
    if (json.is_structured()) {
        std::ranges::for_each(json, [&](const Json &part) { learn(part); });
    }
}

void JsonMutator::collect(Json &json, Json *parent, const std::string &key, std::size_t index,
                          std::vector<Node> &nodes) {
    constexpr std::size_t most_nodes = 20000;
    if (nodes.size() > most_nodes) {
        return;
    }
    nodes.push_back({&json, parent, key, index});
    if (json.is_object()) {
        for (auto member = json.begin(); member != json.end(); ++member) {
            collect(*member, &json, member.key(), 0, nodes);
        }
    } else if (json.is_array()) {
        for (std::size_t i = 0; i < json.size(); ++i) {
            collect(json[i], &json, key, i, nodes); // elements are as the array's key has them
        }
    }
}

Json JsonMutator::value_for(const std::string &key, Dice &dice) const {
    const auto known = values_.find(key);
    switch (roll(dice, 5)) {
    case 0:
        return one_of(numbers(), dice);
    case 1:
        return one_of(oddities(), dice);
    case 2:
        return all_values_.empty() ? Json() : one_of(all_values_, dice);
    default:
        return known != values_.end() && !known->second.empty() ? one_of(known->second, dice) : Json(1);
    }
}

void JsonMutator::change_value(Json &value, Dice &dice) {
    if (value.is_number() && roll(dice, 2) == 0) {
        const double number = value.get<double>();
        constexpr std::array factors{-1.0, 2.0, 0.5, 10.0, 1.0000001, 1e3, 1e-3};
        value = roll(dice, 3) == 0 ? number + 1 : number * one_of(factors, dice);
        if (const double whole = value.get<double>(); whole == std::trunc(whole) && std::abs(whole) < 1e15) {
            value = static_cast<std::int64_t>(whole);
        }
    } else if (value.is_string() && roll(dice, 2) == 0) {
        auto text = value.get<std::string>();
        const std::size_t at = roll(dice, text.size() + 1);
        switch (roll(dice, 4)) {
        case 0:
            text = text.substr(0, at);
            break;
        case 1:
            text.insert(at, 1, static_cast<char>(1 + roll(dice, 127)));
            break;
        case 2:
            text = text.substr(at) + text.substr(0, at);
            break;
        default:
            text += text.size() < 1000 ? text : "";
        }
        value = text;
    } else {
        value = roll(dice, 3) == 0 ? one_of(oddities(), dice) : one_of(numbers(), dice);
    }
}

void JsonMutator::change(Json &root, Dice &dice) const {
    std::vector<Node> nodes;
    collect(root, nullptr, "", 0, nodes);
    const Node node = one_of(nodes, dice);
    Json &value = *node.value;
    Json *parent = node.parent;
    switch (roll(dice, 10)) {
    case 0:
    case 1:
        return change_value(value, dice);
    case 2:
    case 3:
        value = value_for(node.key, dice);
        return;
    case 4: // out
        if (parent != nullptr && parent->is_object()) {
            parent->erase(node.key);
        } else if (parent != nullptr) {
            parent->erase(node.index);
        }
        return;
    case 5: // in
    case 6:
        if (Json &into = parent != nullptr && !value.is_structured() ? *parent : value; into.is_object()) {
            const std::string key = keys_.empty() ? "a" : one_of(keys_, dice);
            into[key] = value_for(key, dice);
        } else if (into.is_array()) {
            into.push_back(value_for(node.key, dice));
        }
        return;
    case 7: // doubled, now and then many times
        if (value.is_array() && !value.empty()) {
            constexpr std::array times{1, 1, 1, 2, 8, 64, 1000};
            const Json element = one_of(value, dice);
            for (int i = one_of(times, dice); i > 0; --i) {
                value.push_back(element);
            }
        }
        return;
    case 8: // exchanged
        if (const Node &other = one_of(nodes, dice); !value.is_structured() && !other.value->is_structured()) {
            std::swap(value, *other.value);
        }
        return;
    default: // wrapped or unwrapped
        if (value.is_structured() && !value.empty()) {
            Json part = one_of(value, dice);
            value = std::move(part);
        } else {
            value = Json::array({value});
        }
    }
}

std::optional<std::string> JsonMutator::changed(std::string_view text, unsigned seed, std::size_t most) const {
    auto json = parsed(text);
    if (!json) {
        return std::nullopt;
    }
    Dice dice(seed);
    for (std::size_t turns = 1 + roll(dice, 4) * roll(dice, 2); turns > 0; --turns) {
        change(*json, dice);
    }
    return printed(*json, most);
}

std::optional<std::string> JsonMutator::crossed(std::string_view text, std::string_view other, unsigned seed,
                                                std::size_t most) const {
    auto json = parsed(text);
    auto from = parsed(other);
    if (!json || !from) {
        return std::nullopt;
    }
    Dice dice(seed);
    std::vector<Node> places, parts;
    collect(*json, nullptr, "", 0, places);
    collect(*from, nullptr, "", 0, parts);
    const Node place = one_of(places, dice);
    std::erase_if(parts, [&](const Node &part) { return part.key != place.key; });
    Json part = parts.empty() ? *from : *one_of(parts, dice).value;
    *place.value = std::move(part);
    return printed(*json, most);
}

} // namespace sandbox
