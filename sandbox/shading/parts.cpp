#include "shading/parts.h"

#include "image/error.h"

namespace sandbox {
namespace {

std::map<std::string, std::string, std::less<>> read_parts(const Assets &assets) {
    std::map<std::string, std::string, std::less<>> texts;
    for (const auto &path : assets.list("")) {
        if (path.ends_with(".glsl")) {
            texts[path] = assets.read(path).value_or("");
        }
    }
    return texts;
}

} // namespace

ShaderParts::ShaderParts(Assets shaders) : assets_(std::move(shaders)), texts_(read_parts(assets_)) {
    if (texts_.empty()) {
        throw InputError("--shaders {}: expected .glsl files, found none", assets_.folder().string());
    }
}

const std::string &ShaderParts::text(std::string_view part) const {
    const auto found = texts_.find(part);
    if (found == texts_.end()) {
        throw InputError("shaders: no part '{}'", part);
    }
    return found->second;
}

bool ShaderParts::reload_changed() {
    if (assets_.folder().empty()) {
        return false;
    }
    auto texts = read_parts(assets_);
    if (texts.empty() || texts == texts_) {
        return false;
    }
    texts_ = std::move(texts);
    return true;
}

} // namespace sandbox
