#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sandbox {

/// The known word nearest to a misspelt one, or empty where none is near (more than one edit and one for every
/// three letters).
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> known);

/// `; did you mean "diffuse"?` or, where none is near, `; expected one of a, b, c`.
std::string suggestion(std::string_view word, std::span<const std::string_view> known);

} // namespace sandbox
