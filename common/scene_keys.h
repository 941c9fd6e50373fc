#pragma once
// The one table of what a scene file may say: reading, writing, 'did you mean' and the keys of a bake all come from it.

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "common/scene.h"
#include "common/value_form.h"

namespace eikonal {

/// One key of a section of the file and the member of the struct behind it.
template <class Section>
struct Key {
    std::string_view name;
    /// Throws badInput; the string is the key's full path for messages.
    std::function<void(Section&, const toml::node&, const std::string&)> read;
    /// TOML text of the value; nothing where the value is unset or written under another key.
    std::function<std::optional<std::string>(const Section&)> write;
    ValueForm form = {};
};
template <class Section>
using Keys = std::vector<Key<Section>>;

/// Of these the environment has one.
inline constexpr std::array<std::string_view, 3> kSkyKeys{"image", "color", "gradient"};

const Keys<Domain>& domainKeys();
const Keys<Medium>& mediumKeys();
const Keys<Camera>& cameraKeys();
const Keys<Environment>& environmentKeys();
const Keys<Accuracy>& accuracyKeys();
const Keys<RenderSettings>& renderKeys();

/// Keys of any object, and those of its shape ("radius", "mesh", ...).
const Keys<Object>& objectKeys();
Keys<Object> shapeKeys(const Shape& shape);
/// Keys of a light of this type.
Keys<Light> lightKeys(const Light& light);

/// Reads "shape", "mesh" or "volume" of an object's table, the default of the kind. Throws badInput.
Shape readShapeKind(const toml::table& table, const std::string& path);
/// Name of the shape in files; empty for meshes and volumes, which are named by their file.
std::string_view shapeName(const Shape& shape);

/// Reads "type", the default of the kind. Throws badInput.
Light readLightKind(const toml::table& table, const std::string& path);
/// Name of the light's type in files.
std::string_view lightTypeName(const Light& light);

} // namespace eikonal
