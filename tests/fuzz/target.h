#pragma once

#include "image/error.h"

#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Every reader of bytes that strangers wrote, and what must hold of whatever it accepts. Fuzzers call them
/// (fuzzer.cpp), and every test run, with all seeds and all inputs that once broke one (replay_test.cpp).
namespace sandbox {

struct FuzzTarget {
    std::string_view name;
    /// Hands the bytes to the reader. It returns, whatever they are; it throws where something does not hold.
    void (*check)(std::string_view bytes);
    /// Small inputs that are mostly accepted, for a fuzzer to begin with.
    std::vector<std::string> (*seeds)();
    /// Mostly JSON, to be changed as a tree.
    bool json = false;
};

std::span<const FuzzTarget> fuzz_targets();
/// Throws std::out_of_range.
const FuzzTarget &fuzz_target(std::string_view name);

/// Throws std::logic_error unless it is true.
void held(bool condition, const std::string &what);
/// A refusal is for eyes: some words, not pages.
void held_refusal(const InputError &error);

/// What is read; nothing if it is refused.
template <std::invocable Read> auto accepted(Read read) -> std::optional<decltype(read())> {
    try {
        return read();
    } catch (const InputError &error) {
        held_refusal(error);
        return std::nullopt;
    }
}

/// The files of a folder of the repository that end so.
std::vector<std::string> files_in(const std::string &folder, std::string_view ending);
/// Those of tests/fuzz/FOLDER/TARGET.
std::vector<std::string> kept_inputs(const std::string &folder, std::string_view target);

} // namespace sandbox
