#pragma once

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace sandbox {

/// Is `text` one XML element, its tags nested and closed, its attributes quoted, its text without bare < and &?
inline testing::AssertionResult well_formed(const std::string &text) {
    std::vector<std::string> open;
    bool began = false;
    const auto fails = [](const std::string &why, std::size_t at) {
        return testing::AssertionFailure() << why << " at " << at;
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '&') {
            const std::size_t end = text.find(';', i);
            if (end == std::string::npos || end - i > 6 || end - i < 3) {
                return fails("a bare &", i);
            }
        } else if (text[i] != '<') {
            if (open.empty() && text[i] != '\n') {
                return fails("text outside the element", i);
            }
        } else if (text.compare(i, 2, "</") == 0) {
            const std::size_t end = text.find('>', i);
            const std::string name = text.substr(i + 2, end - i - 2);
            if (open.empty() || open.back() != name) {
                return fails("</" + name + "> closes nothing", i);
            }
            open.pop_back();
            i = end;
        } else {
            const std::size_t end = text.find('>', i), name_end = text.find_first_of(" />", i);
            if (end == std::string::npos || (open.empty() && began)) {
                return fails("a second element, or a tag without an end", i);
            }
            began = true;
            const std::string tag = text.substr(i, end - i);
            std::size_t quotes = 0;
            for (const char &c : tag) {
                quotes += c == '"' ? 1 : 0;
                if (c == '=' && quotes % 2 == 0 && tag[static_cast<std::size_t>(&c - tag.data()) + 1] != '"') {
                    return fails("an attribute without quotes", i);
                }
            }
            if (quotes % 2 != 0 || tag.find('<', 1) != std::string::npos) {
                return fails("a quote without its other half", i);
            }
            if (tag.back() != '/') {
                open.push_back(text.substr(i + 1, name_end - i - 1));
            }
            i = end;
        }
    }
    return began && open.empty()
               ? testing::AssertionSuccess()
               : testing::AssertionFailure() << (began ? "<" + open.back() + "> stays open" : "empty");
}

} // namespace sandbox
