#pragma once
// What a bake depends on, as a hash and as keys that can be named.

#include <string>
#include <utility>
#include <vector>

#include "common/fields.h"
#include "common/scene.h"

namespace eikonal {

/// Keys of the scene that a bake depends on, in the order of the file, with their TOML text: domain, medium, objects,
/// lights, accuracy, the environment where it lights the bake, effects allowed. Camera and film are not among them.
std::vector<std::pair<std::string, std::string>> bakeKeys(const Scene& scene);

/// FNV-1a of the keys and of the fields' contents, as 16 hexadecimal digits. Where the hash differs and no key does, a
/// file that the scene names has changed.
std::string sceneHash(const Scene& scene, const Fields& fields);

/// Names of the keys whose text differs or that only one of the two has.
std::vector<std::string> differingKeys(const Scene& a, const Scene& b);

} // namespace eikonal
