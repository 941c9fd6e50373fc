#pragma once
// Scene files in and out (docs/scene.md).

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "common/scene.h"
#include "common/value_form.h"

namespace eikonal {

/// Reads a TOML scene, or a .vdb with an `ior` grid, which gets a default light, camera and sky and is used unresampled.
/// `overrides` are "key.path=value", where objects and lights are counted from 0 or named: "object.ball.ior=1.4".
/// Throws badInput with file:line:column for syntax, unknown keys, wrong types, values out of range, missing files.
Scene loadScene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// The same from text; relative paths start at `folder`, messages name `source`.
Scene parseScene(const std::string& text, const std::string& source, const std::filesystem::path& folder,
                 const std::vector<std::string>& overrides = {});

/// One section of a written scene.
struct WrittenSection {
    std::string header;  ///< "[domain]", "[[object]]"
    std::string path;    ///< "domain", "object.0"
    std::vector<std::pair<std::string, std::string>> values;  ///< key, TOML text
    std::vector<ValueForm> forms;                             ///< one a value
};
std::vector<WrittenSection> writeSections(const Scene& scene);

/// Every value of the scene, defaults included; loading the text from the same folder gives an equal scene.
std::string resolvedToml(const Scene& scene);

/// Text of the scene that a bare volume gets. Throws badInput if the file holds no scalar `ior` grid.
std::string sceneTextForVolume(const std::filesystem::path& volume);

} // namespace eikonal
