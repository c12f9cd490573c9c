#pragma once

#include <compare>
#include <memory>
#include <string>

namespace sandbox {

struct OwnText;

/// The text of the model `own`: a file that somebody wrote, read and accepted; or none. Copies share it; two are equal
/// where file name and text are.
class OwnShader {
  public:
    OwnShader() = default;
    enum class Author { stranger, program };
    /// `file` is what messages call it. Throws InputError "file:line: ..." for what is not accepted (see own_text.h).
    OwnShader(std::string file, std::string text, Author author = Author::stranger);

    /// Written by this program itself: it needs no process of its own.
    [[nodiscard]] bool is_trusted() const { return author_ == Author::program; }

    explicit operator bool() const { return text_ != nullptr; }
    const OwnText &operator*() const { return *text_; }
    const OwnText *operator->() const { return text_.get(); }

    friend std::strong_ordering operator<=>(const OwnShader &a, const OwnShader &b);
    friend bool operator==(const OwnShader &a, const OwnShader &b) { return (a <=> b) == 0; }

  private:
    std::shared_ptr<const OwnText> text_;
    Author author_ = Author::stranger; ///< no part of what it is: equal texts are equal
};

/// The text of a file; an empty name: none. Throws InputError.
OwnShader read_own(const std::string &file);

} // namespace sandbox
