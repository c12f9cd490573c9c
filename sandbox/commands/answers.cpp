#include "commands/answers.h"

#include "image/error.h"
#include "image/image_file.h"
#include "image/plain_text.h"
#include "shading/own_text.h"
#include "teach/marking/marker.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string_view>

namespace sandbox {
namespace {

namespace fs = std::filesystem;

constexpr int deepest_folder = 8; ///< below one that is named: a class, a student, what an archive unpacks to
constexpr std::uintmax_t most_picture_bytes = std::uintmax_t{32} << 20; ///< a .pfm of most_handed_in_pixels has 27 MB

std::string ending_of(const fs::path &path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

bool is_answer(const fs::path &path) {
    constexpr std::array<std::string_view, 3> endings{".glsl", ".png", ".pfm"};
    return std::ranges::find(endings, ending_of(path)) != endings.end();
}

void add_folder(std::vector<AnswerFile> &answers, const fs::path &folder) {
    std::vector<fs::path> found;
    std::error_code failed;
    constexpr auto options = fs::directory_options::skip_permission_denied; // links to folders are not followed
    for (fs::recursive_directory_iterator at(folder, options, failed), end; !failed && at != end;
         at.increment(failed)) {
        if (at.depth() >= deepest_folder) {
            at.disable_recursion_pending();
        }
        if (is_answer(at->path())) {
            found.push_back(at->path());
        }
    }
    if (failed) {
        throw InputError("{}: cannot read the folder ({})", plain_text(folder.string()), failed.message());
    }
    std::ranges::sort(found, {}, [](const fs::path &path) { return path.native(); });
    for (const fs::path &path : found) {
        answers.push_back({path.filename().string(), path, true});
    }
}

/// Two files of one name get the path from the folder that all of that name are in.
void tell_apart(std::vector<AnswerFile> &answers) {
    std::map<std::string, std::vector<AnswerFile *>> by_name;
    for (AnswerFile &answer : answers) {
        by_name[answer.name].push_back(&answer);
    }
    for (const auto &[name, alike] : by_name) {
        if (alike.size() < 2) {
            continue;
        }
        fs::path common = fs::absolute(alike.front()->path).lexically_normal().parent_path();
        for (const AnswerFile *answer : alike) {
            const fs::path whole = fs::absolute(answer->path).lexically_normal();
            while (whole.lexically_relative(common).native().starts_with("..")) {
                common = common.parent_path();
            }
        }
        for (AnswerFile *answer : alike) {
            answer->name = fs::absolute(answer->path).lexically_normal().lexically_relative(common).string();
        }
    }
}

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (const char c : bytes) {
        value = value << 8 | static_cast<unsigned char>(c);
    }
    return value;
}

/// The size that a picture's header tells, before its pixels are unpacked.
void refuse_large_picture(std::string_view bytes) {
    double width = 0, height = 0;
    if (bytes.starts_with(png_signature) && bytes.size() >= 24) {
        width = big_endian(bytes.substr(16, 4));
        height = big_endian(bytes.substr(20, 4));
    } else if (bytes.starts_with("PF") || bytes.starts_with("Pf")) {
        const std::string head(bytes.substr(2, 64));
        if (std::sscanf(head.c_str(), "%lf %lf", &width, &height) != 2) { // NOLINT(cert-err34-c): decode_pfm() tells
            return;
        }
    }
    if (!(width * height <= most_handed_in_pixels)) {
        throw InputError("expected a picture of at most {} pixels, got {:.0f} x {:.0f}", most_handed_in_pixels, width,
                         height);
    }
}

} // namespace

std::vector<AnswerFile> find_answers(const std::vector<fs::path> &given) {
    std::vector<AnswerFile> answers;
    for (const fs::path &path : given) {
        std::error_code failed;
        const fs::file_status status = fs::status(path, failed);
        if (fs::is_directory(status)) {
            add_folder(answers, path);
        } else if (fs::exists(fs::symlink_status(path, failed))) {
            answers.push_back({path.filename().string(), path, false});
        } else {
            throw InputError("{}: there is no such file or folder", plain_text(path.string()));
        }
    }
    std::vector<fs::path> seen;
    std::erase_if(answers, [&](const AnswerFile &answer) {
        const fs::path whole = fs::absolute(answer.path).lexically_normal();
        const bool again = std::ranges::find(seen, whole) != seen.end();
        seen.push_back(whole);
        return again;
    });
    if (answers.empty()) {
        throw InputError("{}: no .glsl, .png or .pfm file is in it", plain_text(given.front().string()));
    }
    tell_apart(answers);
    return answers;
}

Answer read_answer(const AnswerFile &file) {
    std::error_code failed;
    const fs::file_status status =
        file.in_folder ? fs::symlink_status(file.path, failed) : fs::status(file.path, failed);
    if (!fs::is_regular_file(status)) {
        throw InputError("expected a regular file, got {}", fs::is_symlink(status)     ? "a link"
                                                            : fs::is_directory(status) ? "a folder"
                                                                                       : "a device or a pipe");
    }
    if (!is_answer(file.path)) {
        throw InputError("expected a .glsl, .png or .pfm file");
    }
    const bool text = ending_of(file.path) == ".glsl";
    const std::uintmax_t size = fs::file_size(file.path, failed);
    const std::uintmax_t most = text ? most_own_bytes : most_picture_bytes;
    if (failed || size > most) {
        throw InputError("expected a file of at most {} bytes, got {}", most, size);
    }
    const std::string bytes = read_file(file.path);
    const std::string name = plain_text(file.path.filename().string());
    if (text) {
        return OwnShader(name, bytes);
    }
    refuse_large_picture(bytes);
    return decode_observed(bytes, name);
}

} // namespace sandbox
