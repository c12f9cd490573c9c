#include "fuzz/target.h"
#include "fuzz/targets.h"
#include "scene/mtl_reader.h"
#include "scene/scene_file.h"

#include <utility>

namespace sandbox {

/// A material of a model is as one of a scene's file: within the same ranges.
void check_mtl(std::string_view bytes) {
    std::vector<std::string> notes;
    const auto materials = accepted([&] { return read_mtl(source_of(bytes), "a.mtl", Material{}, notes); });
    held(notes.size() < 20, "there are few notes");
    for (const std::string &note : notes) {
        held(note.size() < 500, "a note is short: " + note);
    }
    if (!materials) {
        return;
    }
    Scene scene;
    for (auto [name, material] : *materials) {
        material.texture.clear(); // a path as it stands in the file, which a model's reader resolves
        material.texture_modulates_specular = true;
        scene.objects = {{"", SphereShape{}, {}, material, false}};
        held(parse_scene(scene_text(scene), "again.json", "/nowhere").objects[0].material == material,
             "a material is one of a scene's: " + name);
    }
}

std::vector<std::string> mtl_seeds() {
    return {"newmtl a\nKa 1 1 1\nKd 0.5 0.25 0\nKs 0 0 0\nKe 0 1 0\nNs 96.08\nd 0.5\nillum 2\nmap_Kd a.png\n",
            "\xEF\xBB\xBF# a comment\r\nnewmtl two words\r\nKd 1\r\nmap_Kd -s 2 2 1 -o 0 0 0 dir\\a b.png\r\nmap_Bump "
            "b.png\r\n",
            "newmtl a\nnewmtl b\nKd spectral a.rfl\nKd xyz 1 1 1\nNs 1e-3\nTr 1\nmap_Ks c.png\n"};
}

} // namespace sandbox
