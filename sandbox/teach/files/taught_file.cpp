#include "teach/files/taught_file.h"

#include "image/error.h"
#include "image/file_io.h"
#include "scene/read_json.h"
#include "scene/suggest.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <system_error>

namespace sandbox {
namespace fs = std::filesystem;

TaughtFile taught_file(const fs::path &file) {
    std::error_code error;
    if (file.extension() != ".json" || !fs::is_regular_file(file, error)) {
        return TaughtFile::none;
    }
    try {
        const auto read = read_json<nlohmann::json>(read_file(file, largest_json), file.string());
        const auto has = [&](const char *key) { return read.is_object() && read.contains(key); };
        return has("terms") && has("task")    ? TaughtFile::exercise
               : has("steps") || has("title") ? TaughtFile::lesson
                                              : TaughtFile::none;
    } catch (const InputError &) { // who opens it says what is wrong
        return TaughtFile::none;
    }
}

bool names_file(const fs::path &name_or_file) {
    return name_or_file.has_parent_path() || name_or_file.extension() == ".json";
}

std::string builtin_file(const std::string &name, const std::vector<std::string_view> &folders, const Assets &assets,
                         std::string_view what) {
    std::vector<std::string> names;
    for (const std::string_view folder : folders) {
        for (const std::string &file : assets.list(folder)) {
            names.push_back(fs::path(file).stem().string());
            if (names.back() == name) {
                return file;
            }
        }
    }
    const std::string_view nearest = nearest_word(name, std::vector<std::string_view>(names.begin(), names.end()));
    throw InputError("{}: no built-in {} of that name{}", name, what,
                     nearest.empty() ? " (see: shading-sandbox list)" : fmt::format("; did you mean \"{}\"?", nearest));
}

} // namespace sandbox
