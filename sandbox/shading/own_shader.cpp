#include "shading/own_shader.h"

#include "image/error.h"
#include "image/file_io.h"
#include "shading/own_text.h"

#include <filesystem>
#include <system_error>
#include <utility>

namespace sandbox {

OwnShader::OwnShader(std::string file, std::string text, Author author)
    : text_(std::make_shared<const OwnText>(read_own_text(std::move(file), std::move(text)))), author_(author) {}

std::strong_ordering operator<=>(const OwnShader &a, const OwnShader &b) {
    if (a.text_ == b.text_) {
        return std::strong_ordering::equal;
    }
    if (!a || !b) {
        return bool(a) <=> bool(b);
    }
    const auto by_text = a->text <=> b->text;
    return by_text != 0 ? by_text : a->file <=> b->file;
}

OwnShader read_own(const std::string &file) {
    if (file.empty()) {
        return {};
    }
    std::error_code failed;
    if (!std::filesystem::is_regular_file(file, failed)) {
        throw InputError("'{}': expected a file of GLSL text{}", file,
                         failed ? fmt::format(" ({})", failed.message()) : "");
    }
    const std::uintmax_t size = std::filesystem::file_size(file, failed);
    if (size > most_own_bytes) {
        throw InputError("{}: expected at most {} bytes, got {}", file, most_own_bytes, size);
    }
    return {file, read_file(file)};
}

} // namespace sandbox
