#include "common/scene_values.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "common/expression.h"
#include "common/scene_limits.h"
#include "common/spelling.h"

namespace eikonal {
namespace {

std::string typeText(const toml::node& node) {
    switch (node.type()) {
    case toml::node_type::table: return "a table";
    case toml::node_type::array: return "array";
    case toml::node_type::string: return "string";
    case toml::node_type::integer: return "integer";
    case toml::node_type::floating_point: return "number";
    case toml::node_type::boolean: return "boolean";
    default: return "a date or time";
    }
}

std::string foundText(const toml::node& node) {
    if (node.is_table())
        return typeText(node);
    std::ostringstream value;
    node.visit([&](const auto& concrete) { value << concrete; });
    std::string text = value.str();
    constexpr std::size_t kLongest = 60;
    if (text.size() > kLongest)
        text = text.substr(0, kLongest) + "...";
    return typeText(node) + " " + text;
}

/// "1.5" is as good as 1.5, and cheaper than an expression in every voxel.
std::optional<double> plainNumber(const std::string& text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool all = error == std::errc() && end == text.data() + text.size();
    return all ? std::optional(value) : std::nullopt;
}

void requireMagnitude(double value, const toml::node& node, const std::string& key) {
    if (std::abs(value) > kLargestNumber)
        throw wrongValue(node, key, fmt::format("a number between {:g} and {:g}", -kLargestNumber, kLargestNumber));
}

template <int kCount>
glm::vec<kCount, double> readVector(const toml::node& node, const std::string& key, const Limits& limits) {
    const std::string expected = fmt::format("[{}], numbers{}", kCount == 2 ? "x, y" : "x, y, z", limits.text());
    const toml::array* array = node.as_array();
    if (!array || array->size() != std::size_t(kCount))
        throw wrongValue(node, key, expected);
    glm::vec<kCount, double> result;
    for (int i = 0; i < kCount; ++i)
        result[i] = readNumber((*array)[std::size_t(i)], fmt::format("{}[{}]", key, i), limits);
    return result;
}

} // namespace

bool Limits::contain(double value) const {
    return std::isfinite(value) && (lowOpen ? value > low : value >= low) && (highOpen ? value < high : value <= high);
}

std::string Limits::text() const {
    if (std::isfinite(low) && std::isfinite(high))
        return lowOpen == highOpen ? fmt::format(" from {} to {}{}", low, high, lowOpen ? ", ends excluded" : "")
                                   : fmt::format(" {} {} and {} {}", lowOpen ? ">" : ">=", low, highOpen ? "<" : "<=", high);
    if (std::isfinite(low))
        return fmt::format(" {} {}", lowOpen ? ">" : ">=", low);
    return std::isfinite(high) ? fmt::format(" {} {}", highOpen ? "<" : "<=", high) : std::string();
}

SourcePosition positionOf(const toml::node& node) {
    const toml::source_region& region = node.source();
    const toml::table* table = node.as_table();
    if (!region.path && table && !table->empty())  // `--set` made it, for what is in it
        return positionOf(table->begin()->second);
    SourcePosition position;
    position.file = region.path ? *region.path : "--set";
    if (!isOnCommandLine(position)) {  // line 1 of it says nothing
        position.line = int(region.begin.line);
        position.column = int(region.begin.column);
    }
    return position;
}

SourcePosition positionOf(const toml::table& table, std::initializer_list<std::string_view> keys) {
    for (const std::string_view key : keys)
        if (const toml::node* node = table.get(key); node && isOnCommandLine(positionOf(*node)))
            return positionOf(*node);
    return positionOf(table);
}

Error wrongValue(const toml::node& node, const std::string& key, const std::string& expected) {
    return badInput(fmt::format("{}: {}: expected {}, found {}", describe(positionOf(node)), key, expected,
                                foundText(node)));
}

Error wrongChoice(const toml::node& node, const std::string& key, const std::vector<std::string_view>& names) {
    std::string hint;
    if (const auto word = node.value<std::string_view>())
        hint = didYouMean(*word, names);
    return badInput(fmt::format("{}: {}: expected {}, found {}{}", describe(positionOf(node)), key, listNames(names),
                                foundText(node), hint));
}

double readNumber(const toml::node& node, const std::string& key, const Limits& limits) {
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value || !limits.contain(*value))
        throw wrongValue(node, key, "a number" + limits.text());
    requireMagnitude(*value, node, key);
    return *value;
}

int readInteger(const toml::node& node, const std::string& key, const Limits& limits) {
    const auto value = node.is_integer() ? node.value<int>() : std::nullopt;
    if (!value || !limits.contain(*value))
        throw wrongValue(node, key, "an integer" + limits.text());
    return *value;
}

bool readBool(const toml::node& node, const std::string& key) {
    if (!node.is_boolean())
        throw wrongValue(node, key, "true or false");
    return *node.value<bool>();
}

std::string readString(const toml::node& node, const std::string& key) {
    if (!node.is_string())
        throw wrongValue(node, key, "a string");
    return *node.value<std::string>();
}

glm::dvec2 readVector2(const toml::node& node, const std::string& key, const Limits& limits) {
    return readVector<2>(node, key, limits);
}

glm::dvec3 readVector3(const toml::node& node, const std::string& key, const Limits& limits) {
    return readVector<3>(node, key, limits);
}

Quantity readQuantity(const toml::node& node, const std::string& key, const Limits& limits, Bands bands) {
    Quantity quantity{.constant = glm::dvec3(0.0), .expression = std::nullopt, .where = positionOf(node), .given = true};
    if (node.is_string()) {
        const std::string text = readString(node, key);
        const std::optional<double> number = plainNumber(text);
        if (number && !limits.contain(*number))
            throw wrongValue(node, key, "a number" + limits.text());
        if (number)
            requireMagnitude(*number, node, key);
        if (number)
            quantity.constant = glm::dvec3(*number);
        else
            quantity.expression = Expression(text, quantity.where).text();
    } else if (node.is_array() && bands == Bands::kThree) {
        quantity.constant = readVector3(node, key, limits);
    } else if (node.is_number()) {
        quantity.constant = glm::dvec3(readNumber(node, key, limits));
    } else {
        throw wrongValue(node, key, fmt::format("a number{}{} or an expression", limits.text(),
                                                bands == Bands::kThree ? ", [r, g, b]" : ""));
    }
    return quantity;
}

std::string writeNumber(double value) {
    const double unsignedZero = value == 0.0 ? 0.0 : value;  // -0 would read back as the integer 0
    return fmt::format("{}", unsignedZero);
}

std::string writeString(const std::string& value) {
    std::string text = "\"";
    for (const char c : value) {
        if (c == '"' || c == '\\')
            text += std::string("\\") + c;
        else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            text += fmt::format("\\u{:04X}", static_cast<unsigned char>(c));
        else
            text += c;
    }
    return text + "\"";
}

std::string writeVector(const glm::dvec2& value) {
    return fmt::format("[{}, {}]", writeNumber(value.x), writeNumber(value.y));
}

std::string writeVector(const glm::dvec3& value) {
    return fmt::format("[{}, {}, {}]", writeNumber(value.x), writeNumber(value.y), writeNumber(value.z));
}

std::string writeQuantity(const Quantity& value, Bands bands) {
    if (value.expression)
        return writeString(*value.expression);
    const glm::dvec3& c = value.constant;
    const bool sameForAll = c.x == c.y && c.y == c.z;
    return bands == Bands::kOne || sameForAll ? writeNumber(c.x) : writeVector(c);
}

} // namespace eikonal
