#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace sandbox {

/// Changes JSON as a tree, so that most of what comes out gets past the parser: values are changed, taken out, put in,
/// doubled, moved and wrapped, with the keys and the values of the seeds as a dictionary.
class JsonMutator {
  public:
    explicit JsonMutator(const std::vector<std::string> &seeds);

    /// Of at most `most` bytes. Nothing where `text` is no JSON, or it became too long.
    [[nodiscard]] std::optional<std::string> changed(std::string_view text, unsigned seed, std::size_t most) const;
    /// A part of `other` in place of a part of `text`, if possible one under the same key.
    [[nodiscard]] std::optional<std::string> crossed(std::string_view text, std::string_view other, unsigned seed,
                                                     std::size_t most) const;

  private:
    using Json = nlohmann::ordered_json;
    using Dice = std::minstd_rand;
    struct Node {
        Json *value;
        Json *parent; ///< null: the root
        std::string key;
        std::size_t index;
    };

    std::vector<std::string> keys_;
    std::map<std::string, std::vector<Json>> values_; ///< by their key
    std::vector<Json> all_values_;

    void learn(const Json &json);
    static void collect(Json &json, Json *parent, const std::string &key, std::size_t index, std::vector<Node> &nodes);
    void change(Json &root, Dice &dice) const;
    [[nodiscard]] Json value_for(const std::string &key, Dice &dice) const;
    static void change_value(Json &value, Dice &dice);
};

} // namespace sandbox
