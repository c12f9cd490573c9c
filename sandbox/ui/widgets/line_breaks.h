#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace sandbox {

/// Has it Chinese characters or punctuation?
bool has_chinese(std::string_view text);

/// The text in lines no wider than `width`, as Chinese is set: a line may end beside any Chinese character, but not
/// before closing punctuation or after opening punctuation. A word between them is divided only where it is wider than
/// a line. Spaces at a line's end are dropped. `advance`: how far a character takes the pen, in the unit of `width`.
std::string in_lines(std::string_view text, float width, const std::function<float(char32_t)> &advance);

} // namespace sandbox
