#include "shading/own_calls.h"

#include "shading/own_text.h"

#include <fmt/format.h>
#include <map>
#include <utility>

namespace sandbox {
namespace {

/// A function by name and number of parameters: overloads that differ in types alone count as one.
using FunctionKey = std::pair<std::string, std::size_t>;

class CallGraph {
  public:
    explicit CallGraph(const OwnStructure &s) : s_(s) {
        for (const OwnFunction &function : s.functions) {
            nodes_[{function.name, function.parameters.size()}].bodies.push_back(&function);
        }
    }
    void check_all() {
        for (auto &[key, node] : nodes_) {
            visit(node);
        }
    }

  private:
    /// Of a function with all that it calls.
    struct Size {
        std::size_t tokens = 0, loops = 0;
        void operator+=(const Size &more) {
            tokens += more.tokens;
            loops += more.loops;
        }
    };
    struct Node {
        std::vector<const OwnFunction *> bodies;
        Size size;         ///< no tokens: not counted yet
        bool open = false; ///< being counted
    };

    [[nodiscard]] std::size_t arguments(std::size_t open) const {
        std::size_t count = s_.partner[open] > open + 1 ? 1 : 0;
        for (std::size_t i = open + 1; i < s_.partner[open]; i = s_.after(i)) {
            count += s_.tokens[i].is(",") ? 1 : 0;
        }
        const bool nothing = s_.partner[open] == open + 2 && s_.tokens[open + 1].is("void");
        return nothing ? 0 : count;
    }

    void visit(Node &node) {
        if (node.size.tokens > 0) {
            return;
        }
        node.open = true;
        for (const OwnFunction *function : node.bodies) {
            const std::size_t end = s_.partner[function->body];
            node.size.tokens += end - function->body;
            for (std::size_t i = function->body; i < end; ++i) {
                node.size += size_of_call(i);
                node.size.loops += s_.tokens[i].is("for") || s_.tokens[i].is("while") ? 1 : 0;
                if (node.size.loops > most_inlined_loops) {
                    refuse_own(s_.file, function->line,
                               fmt::format("'{}' and all that it calls have more than {} loops", function->name,
                                           most_inlined_loops));
                }
                if (node.size.tokens > most_inlined_tokens) {
                    refuse_own(s_.file, function->line,
                               fmt::format("'{}' and all that it calls are more than {} words and symbols",
                                           function->name, most_inlined_tokens));
                }
            }
        }
        node.open = false;
    }

    /// What the call at a token adds; nothing if there is none.
    Size size_of_call(std::size_t i) {
        if (!s_.tokens[i].is_word() || !s_.tokens[i + 1].is("(")) {
            return {};
        }
        const auto called = nodes_.find({s_.tokens[i].text, arguments(i + 1)});
        if (called == nodes_.end()) {
            return {};
        }
        if (called->second.open) {
            s_.refuse(s_.tokens[i], fmt::format("'{}' calls itself: recursion is not accepted", s_.tokens[i].text));
        }
        visit(called->second);
        return called->second.size;
    }

    const OwnStructure &s_;
    std::map<FunctionKey, Node> nodes_;
};

} // namespace

void refuse_endless_calls(const OwnStructure &structure) { CallGraph(structure).check_all(); }

} // namespace sandbox
