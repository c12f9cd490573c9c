#pragma once

#include <map>
#include <string>
#include <string_view>

namespace sandbox {

/// The texts that people read, by key, in one language: assets/words/LANGUAGE.json, one object of strings.
class Words {
  public:
    Words() = default;
    /// `json` is the file's text, `file` its name in messages. Throws InputError.
    Words(std::string language, std::string_view json, const std::string &file);

    /// "en", "zh"
    [[nodiscard]] const std::string &language() const { return language_; }
    /// Throws InputError if there is none.
    [[nodiscard]] const std::string &text(std::string_view key) const;

  private:
    std::string language_ = "en";
    std::string file_ = "words/en.json";
    std::map<std::string, std::string, std::less<>> texts_;
};

} // namespace sandbox
