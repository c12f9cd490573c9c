#include "scene/budget.h"

#include "image/error.h"
#include "image/plain_text.h"

#include <fmt/format.h>
#include <type_traits>

namespace sandbox {
namespace {

constexpr std::size_t bytes_a_pixel = 4 * sizeof(float);

/// "512 MB", "4.8 GB": of 1024 each, rounded.
std::string bytes_text(std::size_t bytes) {
    const double mega = static_cast<double>(bytes) / (1 << 20);
    return mega < 1000 ? fmt::format("{:.0f} MB", mega) : fmt::format("{:.1f} GB", mega / 1024);
}

std::size_t of(int count) { return static_cast<std::size_t>(count); }

std::size_t triangles_in(const SphereShape &s) { return 2 * of(s.segments) * of(s.rings - 1); }
std::size_t triangles_in(const BoxShape &s) { return 12 * of(s.divisions) * of(s.divisions); }
std::size_t triangles_in(const PlaneShape &s) { return 2 * of(s.divisions) * of(s.divisions); }
std::size_t triangles_in(const CylinderShape &s) { return 2 * of(s.segments) * of(s.rings + (s.caps ? 1 : 0)); }
std::size_t triangles_in(const TorusShape &s) { return 2 * of(s.rings) * of(s.segments); }
std::size_t triangles_in(const ObjShape &) { return 0; }

} // namespace

void check_sampled(Size size) {
    const std::size_t pixels = of(size.width) * of(size.height);
    if (pixels > most_sampled_pixels) {
        throw InputError("a picture of {}x{} has {:.1f} Mpixel; one that adds up samples may have {}", size.width,
                         size.height, static_cast<double>(pixels) / (1 << 20), most_sampled_pixels >> 20);
    }
}

void SceneBudget::add_texture(std::string_view object, std::string_view texture, Size size) {
    const std::size_t bytes = of(size.width) * of(size.height) * bytes_a_pixel;
    if (bytes > most_texture_bytes - texture_bytes_) {
        throw InputError("{}: its texture {} is {}x{}, {} decoded{}; a scene's textures may take {}", object,
                         plain_text(texture), size.width, size.height, bytes_text(bytes),
                         texture_bytes_ > 0 ? fmt::format(", after {} of others", bytes_text(texture_bytes_)) : "",
                         bytes_text(most_texture_bytes));
    }
    texture_bytes_ += bytes;
}

void SceneBudget::add_triangles(std::string_view object, std::size_t triangles) {
    if (triangles > most_triangles - triangles_) {
        throw InputError("{}: its mesh has {} triangles{}; a scene's meshes may have {}", object, triangles,
                         triangles_ > 0 ? fmt::format(", after {} of others", triangles_) : "", most_triangles);
    }
    triangles_ += triangles;
}

std::string object_name(const Scene &scene, std::size_t index) {
    const std::string &name = scene.objects[index].name;
    return fmt::format("objects[{}]{}", index, name.empty() ? "" : fmt::format(" (\"{:.40}\")", plain_text(name)));
}

std::size_t triangles_of(const Shape &shape) {
    return std::visit([](const auto &one) { return triangles_in(one); }, shape);
}

} // namespace sandbox
