#include "viewer/window/document.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <variant>

#include <fmt/core.h>

#include "common/accuracy.h"
#include "common/error.h"
#include "common/file_kind.h"
#include "common/mesh.h"
#include "common/scene_edit.h"
#include "common/scene_toml.h"

namespace eikonal::window {

namespace {

std::string vectorText(const glm::dvec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

/// A glass figure in thin smoke under one beam, seen from where it fills the picture.
std::string sceneTextForMesh(const std::filesystem::path& mesh) {
    const Bounds bounds = boundsOf(loadMesh(mesh));
    const glm::dvec3 center = 0.5 * (bounds.min + bounds.max);
    const glm::dvec3 extent = bounds.max - bounds.min;
    const double reach = 0.75 * std::max({extent.x, extent.y, extent.z});
    constexpr double kFovDegrees = 35.0;
    const double distance = 1.8 * reach / std::tan(glm::radians(0.5 * kFovDegrees));
    return fmt::format("[domain]\nmin = {}\nmax = {}\nresolution = 64\n[medium]\nscattering = {}\n"
                       "[[object]]\nmesh = \"{}\"\nior = 1.5\n[[light]]\ntype = \"directional\"\ndirection = [1, -0.5, 0]\n"
                       "irradiance = [4, 4, 4]\n[environment]\nintensity = 0.15\n[camera]\nposition = {}\nlook_at = {}\nfov = {}\n",
                       vectorText(center - reach), vectorText(center + reach), 0.25 / reach, mesh.filename().string(),
                       vectorText(center + distance * glm::normalize(glm::dvec3(0.35, 0.3, 1.0))), vectorText(center),
                       kFovDegrees);
}

std::filesystem::path wholePath(const std::filesystem::path& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path.empty() ? "." : path));
}

/// The scene with its paths as they are from another folder.
Scene movedTo(const std::filesystem::path& folder, Scene scene) {
    const bool stays = wholePath(folder) == wholePath(scene.folder);
    const auto fromThere = [&](const std::filesystem::path& path) {
        const bool keep = stays || path.is_absolute();
        return keep ? path : wholePath(scene.resolve(path)).lexically_proximate(wholePath(folder));
    };
    for (Object& object : scene.objects) {
        if (auto* volume = std::get_if<VolumeShape>(&object.shape)) volume->file = fromThere(volume->file);
        if (auto* mesh = std::get_if<MeshShape>(&object.shape)) mesh->file = fromThere(mesh->file);
    }
    if (scene.environment.image) scene.environment.image = fromThere(*scene.environment.image);
    scene.folder = folder;
    return scene;
}

/// The size of pictures that a scene file asks for: the window has its own. That of the scene where the text is none.
glm::ivec2 sizeIn(const std::string& text, const Scene& scene) {
    try {
        return parseScene(text, scene.source, scene.folder).render.size;
    } catch (const Error&) {
        return scene.render.size;
    }
}

Scene sceneOf(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
    Scene scene = isMeshFile(file) ? parseScene(sceneTextForMesh(file), file.string(), file.parent_path(), overrides)
                                   : loadScene(file, overrides);
    requireAvailable(scene);
    return scene;
}

} // namespace

bool isEnvironmentMap(const std::filesystem::path& file) {
    const std::string extension = extensionOf(file);
    return extension == ".hdr" || extension == ".exr";
}

Document::Document(const std::filesystem::path& file, const std::vector<std::string>& overrides)
    : file_(file), overrides_(overrides), scene_(sceneOf(file, overrides)),
      stages_(composeStageFields(scene_)) {}

Redo Document::replace(Scene scene) {
    const Redo redo = redoFor(scene_, scene);
    StageFields stages = stages_;
    if (redo.fields) {
        stages = composeStageFields(scene);
    } else if (redo.insets) {
        stages = movedStageFields(scene, stages_);
    }
    if (redo.image) {
        for (FieldsOfStage* stage : {&stages.light, &stages.image}) stage->effects = decideEffects(scene, *stage->fields);
    }
    scene_ = std::move(scene);
    stages_ = std::move(stages);
    return redo;
}

Redo Document::set(const std::string& override) {
    Scene scene = parseScene(resolvedToml(scene_), scene_.source, scene_.folder, {override});
    requireAvailable(scene);
    return replace(std::move(scene));
}

void Document::reload() {
    Scene scene = sceneOf(file_, overrides_);
    stages_ = composeStageFields(scene);
    scene.camera = scene_.camera;
    scene_ = std::move(scene);
}

std::vector<std::filesystem::path> Document::files() const {
    std::vector<std::filesystem::path> files{file_};
    for (const Object& object : scene_.objects) {
        if (const auto* volume = std::get_if<VolumeShape>(&object.shape)) files.push_back(scene_.resolve(volume->file));
        if (const auto* mesh = std::get_if<MeshShape>(&object.shape)) files.push_back(scene_.resolve(mesh->file));
    }
    if (scene_.environment.image) files.push_back(scene_.resolve(*scene_.environment.image));
    return files;
}

std::string Document::textFor(const std::filesystem::path& folder) const {
    Scene scene = movedTo(folder, scene_);
    if (extensionOf(file_) != ".toml") return resolvedToml(scene);
    std::ifstream file(file_, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    scene.render.size = sizeIn(text, scene_);
    return editedToml(text, scene_.folder, scene);
}

} // namespace eikonal::window
