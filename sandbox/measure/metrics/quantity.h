#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

namespace sandbox {

/// One number of a T, as a row of a table (metric_quantities, run_time_quantities, ...). Files, tables, `compare` and
/// the window read these tables, so that a new number is a new member and a new row.
template <class T> struct Quantity {
    std::string_view name;    ///< its key in JSON, its column in CSV
    std::string_view heading; ///< of its column on a page; empty: pages leave it out
    std::string_view unit;
    std::string_view meaning; ///< in one line
    std::variant<double T::*, std::size_t T::*, int T::*, std::optional<double> T::*, std::optional<int> T::*> member;
    bool costly = false; ///< measured by `compare` alone: it takes longer than all the others together

    /// Nothing where this T has no such number; NaN where nothing could be measured; infinite where a picture was not
    /// finite.
    [[nodiscard]] std::optional<double> value(const T &measured) const {
        return std::visit(
            [&](auto pointer) -> std::optional<double> {
                if constexpr (std::is_same_v<decltype(pointer), std::optional<double> T::*>) {
                    return measured.*pointer;
                } else if constexpr (std::is_same_v<decltype(pointer), std::optional<int> T::*>) {
                    const std::optional<int> &count = measured.*pointer;
                    return count ? *count : std::numeric_limits<double>::quiet_NaN();
                } else {
                    return static_cast<double>(measured.*pointer);
                }
            },
            member);
    }
    /// A count: written without decimals.
    [[nodiscard]] bool whole() const {
        return !std::holds_alternative<double T::*>(member) &&
               !std::holds_alternative<std::optional<double> T::*>(member);
    }
};

/// A quantity in JSON (nlohmann's, which writes null for what is not finite).
template <class Json, class T> Json quantity_json(const Quantity<T> &quantity, const T &measured) {
    const std::optional<double> value = quantity.value(measured);
    const bool whole = value && quantity.whole() && !std::isnan(*value);
    return !value ? Json() : whole ? Json(static_cast<long long>(*value)) : Json(*value);
}

/// Reads what quantity_json() wrote under the quantity's name: null becomes what value() calls NaN, or nothing. What an
/// earlier version did not write stays as it is. Throws the library's exceptions.
template <class Json, class T> void read_quantity(const Json &json, const Quantity<T> &quantity, T &measured) {
    const auto found = json.find(quantity.name);
    if (found == json.end()) {
        return;
    }
    std::visit(
        [&](auto pointer) {
            using Member = std::remove_reference_t<decltype(measured.*pointer)>;
            if constexpr (std::is_integral_v<Member>) {
                found->get_to(measured.*pointer);
            } else if (found->is_null()) {
                measured.*pointer = std::is_same_v<Member, double> ? Member(std::nan("")) : Member();
            } else if constexpr (std::is_same_v<Member, std::optional<int>>) {
                measured.*pointer = found->template get<int>();
            } else {
                measured.*pointer = found->template get<double>();
            }
        },
        quantity.member);
}

} // namespace sandbox
