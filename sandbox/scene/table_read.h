#pragma once

#include "image/error.h"
#include "scene/read_json.h"
#include "scene/scene_format.h"
#include "scene/suggest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Reading JSON objects by tables such as those of scene_format.h: scenes, and lessons.
namespace sandbox {

/// 1e9 rather than 1e+09, -1e9 rather than -1000000000.
std::string number_text(double value);
/// What is wrong with a number, as `<noun> >= 0`, or, beyond the other end, `<noun> from 0 to 1e6`; empty: nothing.
std::string broken_rule(double value, const Range &range, std::string_view noun);
/// The path of a key below `path` ("lights[0].diffuse"), and of an element of an array.
std::string below(const std::string &path, std::string_view key);
std::string element(const std::string &path, std::size_t index);

/// What a Derived reader shares with others. `Json` is nlohmann's, which headers do not name. Derived adds `read` for
/// the types of its own and `finish` for rules that tie several keys together, beside these (`using`). All throw
/// InputError: `name: path: expected ..., got ...`.
template <class Derived, class Json> class TableReader {
  public:
    /// `extra`: a key that is no field of T.
    template <class T>
    void read_object(const Json &json, const std::string &path, T &out, std::string_view extra = {}) const {
        expect(json.is_object(), path, "an object", json);
        check_keys<T>(json, path, extra);
        for_each_field<T>([&](const auto &field) { read_field(json, path, field, out); });
        self().finish(json, path, out);
    }

  protected:
    explicit TableReader(std::string_view name) : name_(name) {}
    [[nodiscard]] const std::string &name() const { return name_; }

    static std::string got(const Json &json) { return ", got " + short_json(json); }
    [[noreturn]] void refuse(const std::string &path, const std::string &what) const {
        throw InputError("{}: {}{}{}", name_, path, path.empty() ? "" : ": ", what);
    }
    void expect(bool good, const std::string &path, const std::string &what, const Json &json) const {
        if (!good) {
            refuse(path, json.is_discarded() ? "missing; expected " + what : "expected " + what + got(json));
        }
    }
    static std::string one_of(const auto &words) {
        std::string list;
        for (const std::string_view word : words) {
            list += fmt::format("{}\"{}\"", list.empty() ? "one of " : ", ", word);
        }
        return list;
    }

    template <class T> void finish(const Json &, const std::string &, T &) const {}

    /// double or int
    template <class Number>
    void read(const Json &json, const std::string &path, const Range &range,
              Number &out) const requires std::is_arithmetic_v<Number> {
        const bool whole = std::is_integral_v<Number>;
        const std::string noun = whole ? "a whole number" : "a number";
        const double value = json.is_number() ? json.template get<double>() : no_number;
        expect(std::isfinite(value) && (!whole || std::trunc(value) == value), path, noun, json);
        const std::string rule = broken_rule(value, range, noun);
        expect(rule.empty(), path, rule, json);
        out = static_cast<Number>(value);
    }
    void read(const Json &json, const std::string &path, const Range &, bool &out) const {
        expect(json.is_boolean(), path, "true or false", json);
        out = json.template get<bool>();
    }
    void read(const Json &json, const std::string &path, const Range &, std::string &out) const {
        expect(json.is_string(), path, "a string", json);
        out = json.template get<std::string>();
    }
    template <class E>
    void read(const Json &json, const std::string &path, const Range &, E &out) const requires HasWords<E> {
        const auto found = std::ranges::find_if(words_of<E>, [&](std::string_view word) { return json == word; });
        expect(found != words_of<E>.end(), path, one_of(words_of<E>), json);
        out = static_cast<E>(found - words_of<E>.begin());
    }
    template <int N>
    void read(const Json &json, const std::string &path, const Range &range, glm::vec<N, double> &out) const {
        expect(json.is_array() && json.size() == N, path, fmt::format("an array of {} numbers", N), json);
        for (int i = 0; i < N; ++i) {
            const auto at = static_cast<std::size_t>(i);
            read(json[at], element(path, at), range, out[i]);
        }
        expect(!range.a_direction || out != glm::vec<N, double>(0), path, "a vector other than (0, 0, 0)", json);
    }
    template <std::size_t N>
    void read(const Json &json, const std::string &path, const Range &range, std::array<glm::dvec3, N> &out) const {
        expect(json.is_array() && json.size() == N, path, fmt::format("an array of {} colours", N), json);
        for (std::size_t i = 0; i < N; ++i) {
            read(json[i], element(path, i), range, out[i]);
        }
    }
    template <class T>
    void read(const Json &json, const std::string &path, const Range &range, std::vector<T> &out) const {
        expect(json.is_array(), path, "an array", json);
        if (static_cast<double>(json.size()) > range.high) {
            refuse(path, fmt::format("expected at most {} elements, got {}", number_text(range.high), json.size()));
        }
        out.assign(json.size(), T{});
        for (std::size_t i = 0; i < json.size(); ++i) {
            self().read(json[i], element(path, i), any, out[i]);
        }
    }
    template <class T>
    void read(const Json &json, const std::string &path, const Range &range, std::optional<T> &out) const {
        self().read(json, path, range, out.emplace());
    }
    template <class T>
    void read(const Json &json, const std::string &path, const Range &, T &out) const requires HasFormat<T> {
        read_object(json, path, out);
    }

  private:
    std::string name_;

    [[nodiscard]] const Derived &self() const { return static_cast<const Derived &>(*this); }

    template <class T> void check_keys(const Json &json, const std::string &path, std::string_view extra) const {
        std::vector<std::string_view> known;
        if (!extra.empty()) {
            known.push_back(extra);
        }
        for_each_field<T>([&](const auto &field) { known.push_back(field.key); });
        for (const auto &[key, value] : json.items()) {
            if (std::ranges::find(known, key) == known.end()) {
                refuse(below(path, key.substr(0, 60)),
                       fmt::format("unknown key of this {}{}", format_of<T>.name, suggestion(key, known)));
            }
        }
    }

    template <class T, class M>
    void read_field(const Json &json, const std::string &path, const Field<T, M> &field, T &out) const {
        const Json missing(Json::value_t::discarded); // nothing expects it
        if (const auto found = json.find(field.key); found != json.end() || field.rules.needed(out)) {
            self().read(found != json.end() ? *found : missing, below(path, field.key), field.range, out.*field.member);
        }
    }
};

} // namespace sandbox
