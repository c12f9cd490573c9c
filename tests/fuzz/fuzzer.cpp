// libFuzzer's entries. The target is named by the program: fuzz_scene is a link to this one.
#include "fuzz/json_mutator.h"
#include "fuzz/png_mutator.h"
#include "fuzz/target.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t *data, std::size_t size, std::size_t most);

namespace {

const sandbox::FuzzTarget *chosen = nullptr;
const sandbox::FuzzTarget &target() { return *chosen; }

const sandbox::JsonMutator &json_mutator() {
    static const sandbox::JsonMutator mutator(target().seeds());
    return mutator;
}

std::string_view text_of(const std::uint8_t *data, std::size_t size) {
    return {reinterpret_cast<const char *>(data), size};
}

std::size_t copied(const std::optional<std::string> &text, std::uint8_t *to) {
    std::memcpy(to, text->data(), text->size());
    return text->size();
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int * /*count*/, char ***arguments) {
    const std::string_view program = (*arguments)[0];
    const std::size_t prefix = program.rfind("fuzz_");
    try {
        chosen = &sandbox::fuzz_target(prefix == std::string_view::npos ? "" : program.substr(prefix + 5));
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        std::exit(2);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    try {
        target().check(text_of(data, size));
    } catch (const std::exception &error) {
        std::fprintf(stderr, "FINDING: %s\n", error.what());
        std::abort();
    }
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t *data, std::size_t size, std::size_t most, unsigned seed) {
    constexpr unsigned of_bytes = 8; // one in so many changes is of bytes: what is no JSON is to be refused, too
    if (target().json && seed % of_bytes != 0) {
        if (const auto text = json_mutator().changed(text_of(data, size), seed / of_bytes, most)) {
            return copied(text, data);
        }
    }
    if (seed % of_bytes != 0) {
        if (const auto file = sandbox::changed_png(text_of(data, size), seed / of_bytes, most, LLVMFuzzerMutate)) {
            return copied(file, data);
        }
    }
    return LLVMFuzzerMutate(data, size, most);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t *one, std::size_t one_size,
                                                 const std::uint8_t *other, std::size_t other_size, std::uint8_t *out,
                                                 std::size_t most, unsigned seed) {
    if (target().json) {
        const auto text = json_mutator().crossed(text_of(one, one_size), text_of(other, other_size), seed, most);
        return text ? copied(text, out) : 0;
    }
    // The beginning of one, then the end of the other.
    const std::size_t head = one_size == 0 ? 0 : seed % one_size;
    const std::size_t tail = std::min(other_size == 0 ? 0 : seed / 7 % other_size, most - std::min(most, head));
    if (head > most) {
        return 0;
    }
    std::copy_n(one, head, out);
    std::copy_n(other + (other_size - tail), tail, out + head);
    return head + tail;
}
