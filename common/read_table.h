#pragma once
// One table of a scene file through its table of keys.

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "common/scene_keys.h"
#include "common/scene_values.h"
#include "common/spelling.h"

namespace eikonal {

/// Reads the keys of one table; `known` are keys that somebody else reads. Throws badInput for a key that is neither.
template <class Section>
void readTable(const toml::table& table, const std::string& path, const Keys<Section>& keys, Section& section,
               std::vector<std::string_view> known = {}) {
    for (const Key<Section>& key : keys) {
        if (std::find(known.begin(), known.end(), key.name) == known.end())
            known.push_back(key.name);
        if (const toml::node* node = table.get(key.name))
            key.read(section, *node, fmt::format("{}.{}", path, key.name));
    }
    for (const auto& [key, value] : table)
        if (std::find(known.begin(), known.end(), key.str()) == known.end())
            throw badInput(fmt::format("{}: unknown key '{}' in {}{}; expected {}", describe(positionOf(value)),
                                       key.str(), path, didYouMean(key.str(), known), listNames(known)));
}

} // namespace eikonal
