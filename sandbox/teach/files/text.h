#pragma once

#include <string>

/// What the files of lessons and exercises are made of, beside plain values.
namespace sandbox {

/// What a person reads, in the language that the file was read in.
struct Text {
    std::string text;
};

/// JSON as it stands in the file: a name, or an object that another reader takes.
struct JsonText {
    std::string json; ///< empty: the key is absent
};

} // namespace sandbox
