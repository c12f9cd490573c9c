#include "capture/opening_view.h"

#include "image/error.h"

namespace sandbox {
namespace {

/// Nothing for an empty text; an error names the key.
template <class Parse> auto parsed(std::string_view name, std::string_view key, std::string_view text, Parse parse) {
    std::optional<decltype(parse(text))> value;
    try {
        if (!text.empty()) {
            value = parse(text);
        }
    } catch (const InputError &error) {
        throw InputError("{}: compare.{}: {}", name, key, error.what());
    }
    return value;
}

} // namespace

OpeningView opening_view(const Scene &scene, std::string_view name) {
    return {parsed(name, "left", scene.compare.left, parse_technique),
            parsed(name, "right", scene.compare.right, parse_technique),
            parsed(name, "layout", scene.compare.layout, parse_layout)};
}

} // namespace sandbox
