#pragma once
// Values of a scene file: each read with its type and range checked, each written so that it reads back the same.
// Reading throws badInput: position, key, what was expected, what was found.

#include <initializer_list>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <glm/glm.hpp>
#include <toml++/toml.h>

#include "common/error.h"
#include "common/scene.h"

namespace eikonal {

/// The range that a number must lie in.
struct Limits {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool lowOpen = false, highOpen = false;  ///< whether the ends themselves are excluded

    bool contain(double value) const;
    std::string text() const;  ///< " > 0", " from 0 to 1", ...
};
inline constexpr Limits kAnyNumber{};
inline constexpr Limits kPositive{.low = 0.0, .lowOpen = true};
inline constexpr Limits kNotNegative{.low = 0.0};
inline constexpr Limits kAnisotropyRange{.low = -1.0, .high = 1.0, .lowOpen = true, .highOpen = true};

template <class Choice>
using Choices = std::span<const std::pair<std::string_view, Choice>>;

SourcePosition positionOf(const toml::node& node);
/// Where values of a table that do not fit together were said: on the command line the first of `keys` that is from there, else
/// the table.
SourcePosition positionOf(const toml::table& table, std::initializer_list<std::string_view> keys);
Error wrongValue(const toml::node& node, const std::string& key, const std::string& expected);
Error wrongChoice(const toml::node& node, const std::string& key, const std::vector<std::string_view>& names);

double readNumber(const toml::node& node, const std::string& key, const Limits& limits);
int readInteger(const toml::node& node, const std::string& key, const Limits& limits);
bool readBool(const toml::node& node, const std::string& key);
std::string readString(const toml::node& node, const std::string& key);
glm::dvec2 readVector2(const toml::node& node, const std::string& key, const Limits& limits);
glm::dvec3 readVector3(const toml::node& node, const std::string& key, const Limits& limits);

enum class Bands { kOne, kThree };
/// A number, with kThree also [r, g, b], or an expression, which is compiled here to find its errors.
Quantity readQuantity(const toml::node& node, const std::string& key, const Limits& limits, Bands bands);

template <class Choice>
Choice readChoice(const toml::node& node, const std::string& key, Choices<Choice> choices) {
    std::vector<std::string_view> names;
    for (const auto& [name, choice] : choices) {
        if (node.value<std::string_view>() == name)
            return choice;
        names.push_back(name);
    }
    throw wrongChoice(node, key, names);
}

std::string writeNumber(double value);
std::string writeString(const std::string& value);
std::string writeVector(const glm::dvec2& value);
std::string writeVector(const glm::dvec3& value);
std::string writeQuantity(const Quantity& value, Bands bands);

template <class Choice>
std::string writeChoice(Choice value, Choices<Choice> choices) {
    for (const auto& [name, choice] : choices)
        if (choice == value)
            return writeString(std::string(name));
    return {};
}

} // namespace eikonal
