// TOML text -> table -> overrides -> sections, each through its table of keys -> checks between values.

#include "common/scene_toml.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/file_kind.h"
#include "common/read_table.h"
#include "common/scene_keys.h"
#include "common/scene_overrides.h"
#include "common/scene_values.h"
#include "common/spelling.h"

namespace eikonal {
namespace {

toml::table parseText(const std::string& text, const std::string& source) {
    try {
        return toml::parse(text, source);
    } catch (const toml::parse_error& error) {
        const toml::source_position& at = error.source().begin;
        throw badInput(fmt::format("{}:{}:{}: not a scene file: {}", source, at.line, at.column, error.description()));
    }
}

template <class Section>
void readSection(const toml::table& root, const std::string& name, const Keys<Section>& keys, Section& section, Scene& scene) {
    const toml::node* node = root.get(name);
    if (!node)
        return;
    if (!node->is_table())
        throw wrongValue(*node, name, fmt::format("a table [{}]", name));
    readTable(*node->as_table(), name, keys, section);
    for (const auto& [key, value] : *node->as_table())
        scene.places.emplace(fmt::format("{}.{}", name, key.str()), positionOf(value));
}

/// Tables of `[[name]]`, empty if there are none.
std::vector<const toml::table*> tablesOf(const toml::table& root, std::string_view name) {
    const toml::node* node = root.get(name);
    if (!node)
        return {};
    std::vector<const toml::table*> tables;
    const toml::array* array = node->as_array();
    if (!array)
        throw wrongValue(*node, std::string(name), fmt::format("tables headed [[{}]]", name));
    for (const toml::node& element : *array) {
        if (!element.is_table())
            throw wrongValue(element, std::string(name), fmt::format("tables headed [[{}]]", name));
        tables.push_back(element.as_table());
    }
    return tables;
}

void requireFile(const Scene& scene, const toml::table& table, const std::string& key, const std::string& path) {
    const toml::node* node = table.get(key);
    if (!node)
        return;
    const std::filesystem::path file = scene.resolve(readString(*node, path + "." + key));
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored) || std::filesystem::is_directory(file, ignored))
        throw badInput(fmt::format("{}: {}.{}: expected a file, found none at '{}'", describe(positionOf(*node)), path,
                                   key, file.string()));
}

void checkShape(const toml::table& table, const std::string& path, const Shape& shape) {
    if (const auto* box = std::get_if<RoundedBoxShape>(&shape)) {
        const double largest = 0.5 * std::min({box->size.x, box->size.y, box->size.z});
        if (box->radius > largest)
            throw badInput(fmt::format("{}: {}.radius: expected at most half the shortest edge, {}, found {}",
                                       describe(positionOf(table, {"radius", "size"})), path, largest, box->radius));
    }
    if (const auto* torus = std::get_if<TorusShape>(&shape); torus && torus->tube > torus->radius)
        throw badInput(fmt::format("{}: {}.tube: expected at most the radius, {}, found {}",
                                   describe(positionOf(table, {"tube", "radius"})), path, torus->radius, torus->tube));
}

Object readObject(const Scene& scene, const toml::table& table, const std::string& path) {
    Object object;
    object.where = positionOf(table, {"volume", "mesh"});
    object.shape = readShapeKind(table, path);
    Keys<Object> keys = shapeKeys(object.shape);
    keys.insert(keys.end(), objectKeys().begin(), objectKeys().end());
    readTable(table, path, keys, object, {"shape", "mesh", "volume"});
    requireFile(scene, table, "mesh", path);
    requireFile(scene, table, "volume", path);
    checkShape(table, path, object.shape);
    return object;
}

Light readLight(const toml::table& table, const std::string& path) {
    Light light = readLightKind(table, path);
    readTable(table, path, lightKeys(light), light, {"type"});
    return light;
}

void checkTopLevel(const toml::table& root) {
    const std::vector<std::string_view> sections{"domain", "medium",      "object",   "light",
                                                 "camera", "environment", "accuracy", "render"};
    for (const auto& [key, value] : root)
        if (std::find(sections.begin(), sections.end(), key.str()) == sections.end())
            throw badInput(fmt::format("{}: unknown section '{}'{}; expected {}", describe(positionOf(value)),
                                       key.str(), didYouMean(key.str(), sections), listNames(sections)));
}

/// Where values of a section that do not fit together were said; the file where the section is left out.
std::string placeOf(const toml::table& root, std::string_view section, std::initializer_list<std::string_view> keys,
                    const Scene& scene) {
    const toml::node* node = root.get(section);
    return node ? describe(positionOf(*node->as_table(), keys)) : scene.source;
}

void checkDomain(const toml::table& root, const Scene& scene) {
    const glm::dvec3 extent = scene.domain.max - scene.domain.min;
    for (int axis = 0; axis < 3; ++axis)
        if (!(extent[axis] > 0.0) || !std::isfinite(extent[axis]))
            throw badInput(fmt::format("{}: domain: expected max > min in {}, found min {} and max {}",
                                       placeOf(root, "domain", {"min", "max"}, scene), "xyz"[axis], scene.domain.min[axis],
                                       scene.domain.max[axis]));
}

void checkCamera(const toml::table& root, const Scene& scene) {
    const glm::dvec3 forward = scene.camera.lookAt - scene.camera.position;
    const double sine = glm::length(glm::cross(forward, scene.camera.up));
    if (!(sine > 1e-9 * glm::length(forward) * glm::length(scene.camera.up)))
        throw badInput(fmt::format("{}: camera: expected look_at away from position and up not along the view, found "
                                   "position {}, look_at {}, up {}",
                                   placeOf(root, "camera", {"position", "look_at", "up"}, scene), writeVector(scene.camera.position),
                                   writeVector(scene.camera.lookAt), writeVector(scene.camera.up)));
}

void checkEnvironment(const toml::table& root, const Scene& scene) {
    const toml::node* node = root.get("environment");
    if (!node)
        return;
    requireFile(scene, *node->as_table(), "image", "environment");
    std::vector<std::string_view> found;
    for (const std::string_view key : kSkyKeys)
        if (node->as_table()->contains(key))
            found.push_back(key);
    if (found.size() > 1)
        throw badInput(fmt::format("{}: environment: expected one of 'image', 'color' and 'gradient', found '{}'",
                                   describe(positionOf(*node)), fmt::join(found, "' and '")));
}

void readScene(const toml::table& root, Scene& scene) {
    checkTopLevel(root);
    readSection(root, "domain", domainKeys(), scene.domain, scene);
    readSection(root, "medium", mediumKeys(), scene.medium, scene);
    for (const toml::table* table : tablesOf(root, "object"))
        scene.objects.push_back(readObject(scene, *table, fmt::format("object.{}", scene.objects.size())));
    for (const toml::table* table : tablesOf(root, "light"))
        scene.lights.push_back(readLight(*table, fmt::format("light.{}", scene.lights.size())));
    readSection(root, "camera", cameraKeys(), scene.camera, scene);
    readSection(root, "environment", environmentKeys(), scene.environment, scene);
    readSection(root, "accuracy", accuracyKeys(), scene.accuracy, scene);
    readSection(root, "render", renderKeys(), scene.render, scene);
    checkDomain(root, scene);
    checkCamera(root, scene);
    checkEnvironment(root, scene);
}

std::string readText(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw badInput(fmt::format("{}: expected a scene file, found a folder", path.string()));
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw badInput(fmt::format("{}: expected a scene file, found none that can be read", path.string()));
    return std::string(std::istreambuf_iterator<char>(file), {});
}

} // namespace

Scene parseScene(const std::string& text, const std::string& source, const std::filesystem::path& folder,
                 const std::vector<std::string>& overrides) {
    toml::table root = parseText(text, source);
    for (const std::string& override : overrides)
        applyOverride(root, override);
    Scene scene;
    scene.source = source;
    scene.folder = folder;
    readScene(root, scene);
    return scene;
}

Scene loadScene(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
    if (isMeshFile(path))
        throw badInput(fmt::format("{}: expected a scene or a VDB, found a mesh; `eikonal voxelize` makes a VDB of it, or a scene "
                                   "says `[[object]]` and `mesh = \"{}\"`",
                                   path.string(), path.filename().string()));
    const std::string text = isVolumeFile(path) ? sceneTextForVolume(path) : readText(path);
    return parseScene(text, path.string(), path.parent_path(), overrides);
}

} // namespace eikonal
