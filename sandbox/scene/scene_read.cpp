#include "scene/scene_read.h"

#include "image/plain_text.h"
#include "scene/model_objects.h"
#include "scene/obj_reader.h"
#include "scene/space.h"
#include "scene/table_read.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

namespace sandbox {
namespace {

template <class S> constexpr bool is_built_in_shape = !std::is_same_v<S, ObjShape>;

std::vector<std::string_view> built_in_shapes() {
    std::vector<std::string_view> names;
    for_each_shape([&]<class S>(std::type_identity<S>) {
        if (is_built_in_shape<S>) {
            names.push_back(format_of<S>.name);
        }
    });
    return names;
}

class Reader : public TableReader<Reader, Json> {
  public:
    Reader(std::string_view name, std::filesystem::path folder) : TableReader(name), folder_(std::move(folder)) {}

  private:
    friend TableReader<Reader, Json>;
    std::filesystem::path folder_;

    using TableReader::read;
    void read(const Json &json, const std::string &path, const Range &, LightType &out) const {
        const auto *kind = std::ranges::find_if(light_kinds, [&](const LightKind &k) { return json == k.word; });
        std::array<std::string_view, light_kinds.size()> words;
        std::ranges::transform(light_kinds, words.begin(), &LightKind::word);
        expect(kind != light_kinds.end(), path, one_of(words), json);
        out = kind->type;
    }
    void read(const Json &json, const std::string &path, const Range &, Shape &out) const {
        expect(json.is_object(), path, "an object with \"shape\" or \"obj\"", json);
        const bool from_file = json.contains("obj");
        if (!from_file) {
            check_shape_word(json, path);
        }
        for_each_shape([&]<class S>(std::type_identity<S>) {
            if (from_file ? !is_built_in_shape<S> : json["shape"] == format_of<S>.name) {
                read_object(json, path, out.emplace<S>(), is_built_in_shape<S> ? "shape" : "");
            }
        });
    }

    void check_shape_word(const Json &json, const std::string &path) const {
        if (!json.contains("shape")) {
            constexpr std::array<std::string_view, 2> known{"shape", "obj"};
            for (const auto &[key, value] : json.items()) { // misspelt, probably
                if (!nearest_word(key, known).empty()) {
                    refuse(below(path, key), "unknown key of this mesh" + suggestion(key, known));
                }
            }
            refuse(path, R"(expected "shape" or "obj")" + got(json));
        }
        const Json &shape = json["shape"];
        expect(shape.is_string(), below(path, "shape"), "a string", shape);
        const auto names = built_in_shapes();
        if (const auto &word = shape.get_ref<const std::string &>(); std::ranges::find(names, word) == names.end()) {
            refuse(below(path, "shape"), "unknown shape" + got(shape) + suggestion(word, names));
        }
    }

    // Rules that tie several keys together.
    using TableReader::finish;
    void finish(const Json &json, const std::string &path, Attenuation &a) const {
        expect(a.constant > 0 || a.linear > 0 || a.quadratic > 0, path, "a coefficient above 0", json);
    }
    void finish(const Json &json, const std::string &path, Light &light) const {
        if (!json.contains("inner_cutoff_degrees")) {
            light.inner_cutoff_degrees = light.cutoff_degrees;
        }
        if (light.inner_cutoff_degrees > light.cutoff_degrees) {
            refuse(below(path, "inner_cutoff_degrees"),
                   fmt::format("expected at most cutoff_degrees ({}){}", number_text(light.cutoff_degrees),
                               got(json["inner_cutoff_degrees"])));
        }
    }
    void finish(const Json &json, const std::string &path, Camera &camera) const {
        if (!(camera.near_plane < camera.far_plane)) {
            refuse(below(path, json.contains("far") ? "far" : "near"),
                   fmt::format("expected near < far, got near {}, far {}", number_text(camera.near_plane),
                               number_text(camera.far_plane)));
        }
        if (camera.target == camera.position) {
            refuse(below(path, "target"), "expected a point other than the camera's position");
        }
        if (up_is_along_view(camera)) {
            const glm::dvec3 &up = camera.up;
            refuse(
                below(path, "up"),
                fmt::format("expected a direction other than the view's, from position to target, got {}[{}, {}, {}]",
                            json.contains("up") ? "" : "the usual ", number_text(up.x), number_text(up.y),
                            number_text(up.z)));
        }
        if (is_orthographic(camera) && json.contains("fov_y_degrees")) {
            refuse(below(path, "fov_y_degrees"), "expected height in its place beside projection orthographic");
        }
        if (is_perspective(camera) && json.contains("height")) {
            refuse(below(path, "height"), "expected fov_y_degrees in its place beside projection perspective");
        }
    }
    void finish(const Json &, const std::string &path, Material &material) const {
        material.texture = resolve_path(material.texture, folder_);
        if (material.checker && !material.texture.empty()) {
            refuse(below(path, "checker"), "expected checker or texture, got both");
        }
    }
    void finish(const Json &, const std::string &path, ObjShape &obj) const {
        if (obj.path.empty()) {
            refuse(below(path, "obj"), "expected a path, got \"\"");
        }
        obj.path = resolve_path(obj.path, folder_);
    }
    void finish(const Json &, const std::string &path, Scene &scene) const {
        std::set<std::string_view> names;
        for (std::size_t i = 0; i < scene.views.size(); ++i) {
            const std::string &view = scene.views[i].name;
            if (!names.insert(view).second) {
                refuse(below(element(below(path, "views"), i), "name"),
                       fmt::format("expected a name of its own, got {} again", short_json(Json(view))));
            }
        }
    }
};

/// The objects of its model in place of one whose materials are the file's.
void put_in_materials(Scene &scene, std::string_view name) {
    std::vector<Object> objects;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object &object = scene.objects[i];
        if (object.materials == MaterialsOf::scene) {
            objects.push_back(object);
            continue;
        }
        try {
            const auto *obj = std::get_if<ObjShape>(&object.mesh);
            if (obj == nullptr || !std::filesystem::path(obj->path).is_absolute()) {
                throw InputError("\"file\" needs the mesh of an .obj file beside the scene");
            }
            if (obj->usemtl) {
                throw InputError("expected usemtl or materials \"file\", got both");
            }
            ModelObjects model = objects_of_model(obj->path, object);
            say_notes(obj->path, model.notes);
            std::ranges::move(model.objects, std::back_inserter(objects));
        } catch (const InputError &error) {
            throw InputError("{}: objects[{}].materials: {}", name, i, error.what());
        }
        if (static_cast<double>(objects.size()) > most_objects) {
            throw InputError("{}: objects[{}].materials: a scene may have {} objects; with this model's it has more",
                             name, i, number_text(most_objects));
        }
    }
    scene.objects = std::move(objects);
}

} // namespace

Scene read_scene(const Json &json, std::string_view name, const std::filesystem::path &folder) {
    Scene scene;
    Reader(name, folder).read_object(json, "", scene, "$schema"); // which is for editors
    scene.looked_in.folder = folder.empty() ? "" : std::filesystem::absolute(folder).lexically_normal().string();
    put_in_materials(scene, name);
    return scene;
}

std::string checked_path(const std::filesystem::path &path) {
    if (!is_utf8(path.string())) { // which a sidecar could not say
        throw InputError("{}: expected a path of UTF-8 text; rename the file or folder", plain_text(path.string()));
    }
    return path.string();
}

std::string resolve_path(const std::string &path, const std::filesystem::path &folder) {
    namespace fs = std::filesystem;
    const fs::path given(path);
    if (path.empty() || given.is_absolute()) {
        return path;
    }
    std::error_code ignored;
    const bool bare = !given.has_parent_path();
    // A file in a folder that may not be searched counts as there: whoever reads it says so.
    const auto missing = [&] { return fs::status(folder / given, ignored).type() == fs::file_type::not_found; };
    if (bare && (folder.empty() || missing())) {
        return path;
    }
    // Above a folder that is a link lies what is above the folder that it leads to.
    const bool climbs = given.begin() != given.end() && *given.begin() == "..";
    const fs::path real = climbs ? fs::weakly_canonical(folder, ignored) : fs::path();
    return checked_path(fs::absolute((real.empty() ? folder : real) / given).lexically_normal());
}

std::string path_from(const std::string &path, const std::filesystem::path &folder) {
    namespace fs = std::filesystem;
    const fs::path file(path);
    if (folder.empty() || !file.is_absolute()) {
        return path;
    }
    fs::path base = fs::absolute(folder).lexically_normal() / "";
    fs::path way = file.lexically_relative(base);
    if (*way.begin() == "..") {
        std::error_code failed;
        base = fs::weakly_canonical(base, failed) / "";
        const fs::path parent = fs::weakly_canonical(file.parent_path(), failed);
        way = (parent / file.filename()).lexically_relative(base);
        const auto climbs = std::ranges::count(way, fs::path(".."));
        if (failed || climbs + 2 == std::distance(base.begin(), base.end())) { // up to the root
            return path;
        }
    }
    return way.has_parent_path() ? way.string() : "./" + way.string(); // a bare name may be a built-in one
}

} // namespace sandbox
