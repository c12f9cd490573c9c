#pragma once

#include "scene/assets.h"

#include <array>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace sandbox {

/// As --lang and the files assets/words/LANGUAGE.json name them; the first is the default.
inline constexpr std::array<std::string_view, 2> languages{"en", "zh"};

/// The texts that people read, by key, in one language: assets/words/LANGUAGE.json, one object of strings. Cheap to
/// copy.
class Words {
  public:
    /// No texts at all.
    Words() = default;
    /// `json` is the file's text, `file` its name in messages. Throws InputError.
    Words(std::string language, std::string_view json, const std::string &file);

    /// "en", "zh"
    [[nodiscard]] const std::string &language() const { return language_; }
    /// In English where this language has none; throws InputError if English has none either.
    [[nodiscard]] const std::string &text(std::string_view key) const;
    /// Null: this language has none.
    [[nodiscard]] const std::string *find(std::string_view key) const;
    /// The text with {0}, {1}, ... filled in; languages may take them in different orders.
    template <class... T> [[nodiscard]] std::string format(std::string_view key, const T &...values) const {
        return fmt::format(fmt::runtime(text(key)), values...);
    }
    [[nodiscard]] const std::map<std::string, std::string, std::less<>> &all() const { return *texts_; }

    /// The same texts in English, which scripts know widgets by.
    [[nodiscard]] const Words &english() const { return english_ ? *english_ : *this; }

  private:
    friend Words words_in(std::string_view language, const Assets &assets);
    static Words read(std::string_view language, const Assets &assets);

    using Texts = std::map<std::string, std::string, std::less<>>;
    std::string language_{languages.front()};
    std::string file_ = "words/en.json";
    std::shared_ptr<const Texts> texts_ = std::make_shared<Texts>();
    std::shared_ptr<const Words> english_; ///< null: these are English
};

/// A text that was put together, set as Chinese is: a space between Chinese and Latin characters, none between Chinese
/// ones or beside their punctuation. In other languages, the text itself.
std::string spaced(const Words &words, const std::string &text);

/// The language itself. Throws InputError naming those there are.
std::string checked_language(const std::string &text);

/// The texts in `language`: those of `assets`, or the copies inside the executable where it has none. Throws
/// InputError.
Words words_in(std::string_view language, const Assets &assets = Assets("assets"));

} // namespace sandbox
