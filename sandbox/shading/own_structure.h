#pragma once

#include "shading/own_tokens.h"

#include <set>
#include <string>
#include <vector>

namespace sandbox {

struct OwnParameter {
    std::string type, name; ///< the name may be empty
    bool writes = false;    ///< out or inout
};

/// A function that the text defines.
struct OwnFunction {
    std::string type, name;
    std::vector<OwnParameter> parameters;
    std::size_t body = 0; ///< the token '{'
    int line = 0;
};

struct OwnStruct {
    std::string name;
    int fields = 0;
};

/// The tokens of own shading with what belongs together.
struct OwnStructure {
    std::string file;
    std::vector<OwnToken> tokens;
    std::vector<std::size_t> partner; ///< of a bracket, the one that closes or opens it; else its own index
    std::vector<OwnFunction> functions;
    std::vector<OwnStruct> structs;

    [[noreturn]] void refuse(const OwnToken &token, const std::string &message) const {
        refuse_own(file, token.line, message);
    }
    /// The token after this one, or after the brackets that this one opens.
    [[nodiscard]] std::size_t after(std::size_t i) const { return (partner[i] > i ? partner[i] : i) + 1; }
    [[nodiscard]] bool is_type(const std::string &word) const;
    /// How many numbers a value of the type holds, at most.
    [[nodiscard]] int numbers_in(const std::string &type) const;
};

/// Throws InputError where brackets do not pair or are too deep, and for a struct that holds an array or a struct.
OwnStructure own_structure(std::vector<OwnToken> tokens, const std::string &file);

/// Throws InputError for an array whose length is not a number from 1 to longest_own_array or light_count, and for
/// arrays that hold too much together.
void refuse_large_arrays(const OwnStructure &structure);

} // namespace sandbox
