#pragma once

#include "scene/scene.h"
#include "shading/parts.h"
#include "shading/technique.h"

#include <string>

namespace sandbox {

/// Whom a file is written for: a scene and the name that commands give it, or no scene in particular.
struct OwnReader {
    const Scene *scene = nullptr;
    std::string name = "SCENE";
};

/// A file to begin with: the interface as comments, and an empty lighting().
std::string own_starter(const OwnReader &reader, const Technique &technique, const ShaderParts &parts);
/// The textbook's file for the technique's model; of a scene, only what the scene needs.
std::string own_answer(const OwnReader &reader, const Technique &technique, const ShaderParts &parts);

} // namespace sandbox
