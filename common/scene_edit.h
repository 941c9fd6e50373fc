#pragma once
// A scene file with other values: what its author wrote around them stays.

#include <filesystem>
#include <string>

#include "common/scene.h"

namespace eikonal {

/// `text` with those values replaced, added or removed in which `scene` differs from what the text says; comments, order and
/// spelling of all others stay. Reading the result from the scene's folder gives an equal scene. Where that cannot be had
/// (a text that is no scene, other objects, values in inline tables) it is resolvedToml(scene). `folder`: where the paths in the
/// text start.
std::string editedToml(const std::string& text, const std::filesystem::path& folder, const Scene& scene);

} // namespace eikonal
