#pragma once

#include "render/gl_program.h"

#include <fmt/format.h>
#include <string>

namespace sandbox {

/// Puts values into those uniforms that the program has, and counts them.
class Uploader {
  public:
    explicit Uploader(const GlProgram &program) : program_(program) {}

    template <typename Value> void put(const std::string &name, const Value &value) {
        if (program_.has(name)) {
            program_.set(name, value);
            ++count_;
        }
    }

    /// Counts as set: elements of an array from `first` on, which the program will not read.
    void skip_from(const std::string &array, int first) {
        for (const auto &[name, location] : program_.uniforms()) {
            count_ += name.starts_with(array) && std::stoi(name.substr(array.size())) >= first ? 1U : 0U;
        }
    }

    void require_all_set() const {
        if (count_ != program_.uniforms().size()) {
            throw std::logic_error(
                fmt::format("the program has {} active uniforms, {} were set", program_.uniforms().size(), count_));
        }
    }

  private:
    const GlProgram &program_;
    std::size_t count_ = 0;
};

} // namespace sandbox
