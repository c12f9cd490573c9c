#include "words/words.h"

#include "image/error.h"
#include "image/system_font.h"
#include "scene/read_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace sandbox {

Words::Words(std::string language, std::string_view json, const std::string &file)
    : language_(std::move(language)), file_(file) {
    const nlohmann::json read = read_json<nlohmann::json>(json, file);
    if (!read.is_object()) {
        throw InputError("{}: expected a JSON object of texts", file);
    }
    Texts texts;
    for (const auto &[key, text] : read.items()) {
        if (!text.is_string()) {
            throw InputError("{}: {}: expected a string, got {}", file, key.substr(0, 60), short_json(text));
        }
        texts.emplace(key, text.get<std::string>());
    }
    texts_ = std::make_shared<Texts>(std::move(texts));
}

const std::string *Words::find(std::string_view key) const {
    const auto found = texts_->find(key);
    return found == texts_->end() ? nullptr : &found->second;
}

const std::string &Words::text(std::string_view key) const {
    if (const std::string *found = find(key)) {
        return *found;
    }
    if (english_) {
        return english_->text(key);
    }
    throw InputError("{} has no text \"{}\"", file_, key);
}

std::string spaced(const Words &words, const std::string &text) {
    if (words.language() != "zh") {
        return text;
    }
    enum class Kind { none, space, latin, chinese, punctuation };
    const auto kind_of = [](char32_t code) {
        const bool wide_mark =
            (code >= 0x3000 && code <= 0x303F) || code >= 0xFF00 || (code >= 0x2018 && code <= 0x2026); // quotes, dots
        return wide_mark               ? Kind::punctuation
               : code >= first_chinese ? Kind::chinese
               : code == ' '           ? Kind::space
                                       : Kind::latin;
    };
    std::string out;
    Kind before = Kind::none; // of the last character that is no space
    bool apart = false;       // it is followed by spaces
    for (std::string_view rest = text; !rest.empty();) {
        const std::string_view here = rest;
        const Kind kind = kind_of(take_character(rest));
        if (kind == Kind::space) {
            apart = true;
            continue;
        }
        const bool mixed =
            (before == Kind::latin && kind == Kind::chinese) || (before == Kind::chinese && kind == Kind::latin);
        out += mixed || (apart && before == Kind::latin && kind == Kind::latin) ? " " : "";
        out += here.substr(0, here.size() - rest.size());
        before = kind;
        apart = false;
    }
    return out;
}

std::string checked_language(const std::string &text) {
    if (std::ranges::find(languages, text) == languages.end()) {
        throw InputError("expected {}, got '{}'", fmt::join(languages, " or "), text);
    }
    return text;
}

Words words_in(std::string_view language, const Assets &assets) {
    if (language == languages.front() && assets.folder().empty()) {
        static const Words english = Words::read(language, assets); // every run of a report asks for it
        return english;
    }
    return Words::read(language, assets);
}

Words Words::read(std::string_view language, const Assets &assets) {
    const std::string file = fmt::format("words/{}.json", language);
    const auto own = assets.read(file);
    const auto text = own ? own : Assets("assets").read(file);
    if (!text) {
        throw InputError("{}: there is no such file", file);
    }
    Words words(std::string(language), *text, file);
    if (language != languages.front()) {
        words.english_ = std::make_shared<Words>(words_in(languages.front(), assets));
    }
    return words;
}

} // namespace sandbox
