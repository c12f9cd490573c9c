#pragma once

#include "render/gl_program.h"
#include "shading/constant_text.h"

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <string>

namespace sandbox {

/// Takes the values of an object's uniforms, also of those that its program lacks.
class UniformSink {
  public:
    UniformSink() = default;
    virtual ~UniformSink() = default;
    UniformSink(const UniformSink &) = delete;
    UniformSink &operator=(const UniformSink &) = delete;

    virtual void put(const std::string &name, int value) = 0;
    virtual void put(const std::string &name, unsigned value) = 0;
    virtual void put(const std::string &name, float value) = 0;
    virtual void put(const std::string &name, const glm::vec3 &value) = 0;
    virtual void put(const std::string &name, const glm::mat3 &value) = 0;
    virtual void put(const std::string &name, const glm::mat4 &value) = 0;
    /// No value: elements of an array from `first` on, which the program will not read.
    virtual void skip_from(const std::string &array, int first) = 0;
};

/// Puts values into those uniforms that the program has, and counts them.
class Uploader : public UniformSink {
  public:
    explicit Uploader(const GlProgram &program) : program_(program) {}

    void put(const std::string &name, int value) override { upload(name, value); }
    void put(const std::string &name, unsigned value) override { upload(name, value); }
    void put(const std::string &name, float value) override { upload(name, value); }
    void put(const std::string &name, const glm::vec3 &value) override { upload(name, value); }
    void put(const std::string &name, const glm::mat3 &value) override { upload(name, value); }
    void put(const std::string &name, const glm::mat4 &value) override { upload(name, value); }
    void skip_from(const std::string &array, int first) override {
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
    template <typename Value> void upload(const std::string &name, const Value &value) {
        if (program_.has(name)) {
            program_.set(name, value);
            ++count_;
        }
    }

    const GlProgram &program_;
    std::size_t count_ = 0;
};

/// Keeps what is a number, a vector or a matrix: what a baked program has as constants.
class UniformRecorder : public UniformSink {
  public:
    void put(const std::string & /*name*/, int /*value*/) override {}
    void put(const std::string & /*name*/, unsigned /*value*/) override {}
    void put(const std::string &name, float value) override { keep(name, &value, 1); }
    void put(const std::string &name, const glm::vec3 &value) override { keep(name, glm::value_ptr(value), 3); }
    void put(const std::string &name, const glm::mat3 &value) override { keep(name, glm::value_ptr(value), 9); }
    void put(const std::string &name, const glm::mat4 &value) override { keep(name, glm::value_ptr(value), 16); }
    void skip_from(const std::string & /*array*/, int /*first*/) override {}

    [[nodiscard]] UniformValues take() { return std::move(values_); }

  private:
    void keep(const std::string &name, const float *numbers, int count) {
        UniformValue &value = values_[name];
        value.count = count;
        std::copy_n(numbers, count, value.numbers.begin());
    }
    UniformValues values_;
};

} // namespace sandbox
