#include "common/scene_overrides.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "common/error.h"
#include "common/scene_keys.h"
#include "common/scene_values.h"

namespace eikonal {
namespace {

std::vector<std::string> splitPath(const std::string& path) {
    std::vector<std::string> parts(1);
    for (const char c : path) {
        if (c == '.')
            parts.emplace_back();
        else if (c != ' ')
            parts.back() += c;
    }
    return parts;
}

toml::table parseValue(const std::string& value, const std::string& source) {
    try {
        return toml::parse("value = " + value, source);
    } catch (const toml::parse_error&) {
        return toml::parse("value = " + writeString(value), source);
    }
}

/// An element by its number or by its `name`.
toml::node* findElement(toml::array& array, const std::string& part) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    if (error == std::errc() && end == part.data() + part.size())
        return array.get(index);
    for (toml::node& element : array)
        if (const toml::table* table = element.as_table(); table && (*table)["name"].value<std::string>() == part)
            return &element;
    return nullptr;
}

toml::node* step(toml::node& node, const std::string& part) {
    if (toml::array* array = node.as_array())
        return findElement(*array, part);
    toml::table* table = node.as_table();
    if (!table)
        return nullptr;
    if (!table->contains(part) && part != "object" && part != "light")
        table->insert(part, toml::table());
    return table->get(part);
}

/// Why there is nothing at parts[i], whose parent `place` is.
std::string nothingAt(const toml::node& place, const std::vector<std::string>& parts, std::size_t i) {
    const toml::array* array = place.as_array();
    if (!array)
        return fmt::format("the scene has no '{}' to set a value of", parts[i]);
    return fmt::format("expected the number, from 0, or the name of one of the scene's {} {}{}, found '{}'", array->size(),
                       parts[i - 1], array->size() == 1 ? "" : "s", parts[i]);
}

/// Of image, color and gradient the one that is set takes the place of the one that was.
void displaceSky(toml::table& environment, const std::string& set) {
    if (std::find(kSkyKeys.begin(), kSkyKeys.end(), set) == kSkyKeys.end())
        return;
    for (const std::string_view key : kSkyKeys)
        if (key != set)
            environment.erase(key);
}

} // namespace

void applyOverride(toml::table& scene, const std::string& override) {
    const std::size_t equals = override.find('=');
    const std::string source = "--set " + override;
    if (equals == std::string::npos || equals == 0)
        throw Error(ExitCode::kUsage, fmt::format("{}: expected key.path=value", source));
    const std::vector<std::string> parts = splitPath(override.substr(0, equals));
    toml::node* place = &scene;
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
        toml::node* next = step(*place, parts[i]);
        if (!next)
            throw badInput(fmt::format("{}: {}", source, nothingAt(*place, parts, i)));
        place = next;
    }
    toml::table* table = place->as_table();
    if (!table)
        throw badInput(fmt::format("{}: expected the path of a single value, as in 'domain.resolution' or "
                                   "'object.0.ior'",
                                   source));
    if (parts.size() == 2 && parts.front() == "environment")
        displaceSky(*table, parts.back());
    toml::table parsed = parseValue(override.substr(equals + 1), source);
    parsed.get("value")->visit([&](auto& value) { table->insert_or_assign(parts.back(), std::move(value)); });
}

} // namespace eikonal
