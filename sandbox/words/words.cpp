#include "words/words.h"

#include "image/error.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace sandbox {

Words::Words(std::string language, std::string_view json, const std::string &file)
    : language_(std::move(language)), file_(file) {
    const nlohmann::json read = nlohmann::json::parse(json, nullptr, false);
    if (!read.is_object()) {
        throw InputError("{}: expected a JSON object of texts", file);
    }
    for (const auto &[key, text] : read.items()) {
        if (!text.is_string()) {
            throw InputError("{}: {}: expected a string, got {}", file, key, text.dump());
        }
        texts_.emplace(key, text.get<std::string>());
    }
}

const std::string &Words::text(std::string_view key) const {
    const auto found = texts_.find(key);
    if (found != texts_.end()) {
        return found->second;
    }
    throw InputError("{} has no text \"{}\"", file_, key);
}

} // namespace sandbox
