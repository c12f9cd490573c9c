#pragma once

#include "image/picture_size.h"
#include "scene/table_read.h"
#include "shading/technique.h"
#include "teach/files/text.h"
#include "words/words.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace sandbox {

/// Runs `work`; what it says is wrong is said with the file and the key.
template <typename Work> auto at(const std::string &place, Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const InputError &error) {
        throw InputError("{}: {}", place, error.what());
    }
}

/// Reads what lessons and exercises share: texts, scenes as they stand, techniques, sizes. See TableReader.
template <class Derived, class Json> class TextReader : public TableReader<Derived, Json> {
    using Base = TableReader<Derived, Json>;

  protected:
    TextReader(const std::string &file, const Words &words) : Base(file), words_(words) {}

    using Base::expect;
    using Base::name;
    using Base::read;
    using Base::refuse;

    void read(const Json &json, const std::string &path, const Range &, Text &out) const {
        expect(json.is_string() || (json.is_object() && !json.empty()), path,
               "a text, \"@key\" or {\"en\": ..., \"zh\": ...}", json);
        if (json.is_object()) {
            out.text = in_language(json, path);
        } else if (const auto &text = json.template get_ref<const std::string &>(); text.starts_with('@')) {
            out.text = at(name() + ": " + path, [&] { return words_.text(std::string_view(text).substr(1)); });
        } else {
            out.text = text;
        }
    }
    void read(const Json &json, const std::string &path, const Range &, JsonText &out) const {
        expect(json.is_string() || json.is_object(), path, "a name or an object", json);
        out.json = json.dump();
    }
    void read(const Json &json, const std::string &path, const Range &, Technique &out) const {
        expect(json.is_string(), path, "a technique", json);
        out = at(name() + ": " + path, [&] { return parse_technique(json.template get<std::string>()); });
    }
    void read(const Json &json, const std::string &path, const Range &, Size &out) const {
        expect(json.is_string(), path, "a size such as \"320x240\"", json);
        out = at(name() + ": " + path, [&] { return parse_size(json.template get<std::string>()); });
    }

  private:
    const Words &words_;

    [[nodiscard]] std::string in_language(const Json &json, const std::string &path) const {
        for (const auto &[key, text] : json.items()) {
            if (std::ranges::find(languages, key) == languages.end()) {
                refuse(below(path, key), "unknown language" + suggestion(key, languages));
            }
            expect(text.is_string(), below(path, key), "a string", text);
        }
        const auto own = json.find(words_.language());
        return *(own != json.end() ? own : json.begin());
    }
};

} // namespace sandbox
