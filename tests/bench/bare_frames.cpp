#include "bare_context.h"
#include "opponent.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string_view>

/// The least program that draws frames by `time --frames -`'s protocol: the nanosecond at which the first is finished,
/// then for every number on standard input a line of as many milliseconds.
namespace {

using Clock = std::chrono::steady_clock;

/// Of "lean/per-vertex/bytes".
sandbox::Opponent::Kind kind_of(std::string_view text) {
    using Opponent = sandbox::Opponent;
    const auto has = [&](std::string_view word) { return text.find(word) != std::string_view::npos; };
    return {.writing = has("lean")    ? Opponent::Writing::lean
                       : has("plain") ? Opponent::Writing::plain
                                      : Opponent::Writing::textbook,
            .shading = has("per-vertex") ? Opponent::Shading::per_vertex : Opponent::Shading::per_pixel,
            .pixels = has("bytes") ? Opponent::Pixels::bytes : Opponent::Pixels::light};
}

} // namespace

int main(int argc, char **argv) {
    using namespace sandbox;
    if (argc != 2) {
        std::fprintf(stderr, "usage: bare_frames textbook|plain|lean/per-pixel|per-vertex/light|bytes\n");
        return 2;
    }
    make_bare_context();
    const Opponent opponent(three_lights_on_a_sphere(), kind_of(argv[1]), {800, 600});
    opponent.frame();
    const auto first = std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch());
    std::printf("{\"case\": \"%s\", \"first_ns\": %lld}\n", argv[1], static_cast<long long>(first.count()));
    std::fflush(stdout);
    char line[32];
    while (std::fgets(line, sizeof line, stdin) != nullptr) {
        const int frames = std::atoi(line);
        std::printf("{\"ms\": [");
        for (int i = 0; i < frames; ++i) {
            const auto begin = Clock::now();
            opponent.frame();
            const double ms = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
            std::printf("%s%.6f", i > 0 ? ", " : "", ms);
        }
        std::printf("]}\n");
        std::fflush(stdout);
    }
    return 0;
}
