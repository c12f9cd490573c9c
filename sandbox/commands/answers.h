#pragma once

#include "measure/diagnosis/levels.h"
#include "shading/own_shader.h"

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

/// Files that students handed in.
namespace sandbox {

struct AnswerFile {
    std::string name; ///< the file's; of two alike, the path from the folder that both are in
    std::filesystem::path path;
    bool in_folder = false; ///< found in a folder that was named, not named itself
};

/// The answers among `given`, in order: files, and of folders, with the folders in them, their .glsl, .png and .pfm files
/// by path. Throws
/// InputError for what does not exist, and if there is no answer.
std::vector<AnswerFile> find_answers(const std::vector<std::filesystem::path> &given);

/// An answer, read: own shading or a picture. Its size is asked before it is read, and nothing but regular files is
/// read; of a folder no links either, which may lead out of it. Throws InputError saying what is wrong with it.
using Answer = std::variant<OwnShader, Observed>;
Answer read_answer(const AnswerFile &file);

} // namespace sandbox
