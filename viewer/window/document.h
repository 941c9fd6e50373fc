#pragma once
// The scene that is open, with what follows from it, and the files that it was made of.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "common/scene.h"
#include "common/stage_fields.h"
#include "viewer/window/redo.h"

namespace eikonal::window {

/// By its name.
bool isEnvironmentMap(const std::filesystem::path& file);

class Document {
public:
    /// A scene, a volume, or a mesh, which gets the surroundings of a bare volume and the index of glass. Throws badInput as
    /// loadScene and composeStageFields.
    Document(const std::filesystem::path& file, const std::vector<std::string>& overrides);

    const Scene& scene() const { return scene_; }
    /// As viewing rays see the scene.
    const FieldsOfStage& image() const { return stages_.image; }
    /// As light does.
    const FieldsOfStage& light() const { return stages_.light; }
    const Lattice& domain() const { return stages_.image.fields->lattice; }
    bool wantsLight() const { return stages_.image.effects.wantsLight(scene_); }
    const std::filesystem::path& file() const { return file_; }

    void setCamera(const Camera& camera) { scene_.camera = camera; }
    void setLight(std::size_t index, const Light& light) { scene_.lights[index] = light; }
    /// Another scene in place of this one, with fields and effects where they depend on what differs.
    /// Throws badInput as composeStageFields; the document is then as it was.
    Redo replace(Scene scene);
    /// "key.path=value", as --set has it. Throws badInput for what the scene file would refuse; the same then.
    Redo set(const std::string& override);
    /// Reads the file again; the camera stays where it is. Throws badInput; the document is then as it was.
    void reload();
    /// Its own file and those that the scene names.
    std::vector<std::filesystem::path> files() const;
    /// The scene as a file for a folder: its own file's text with the values that differ, or one of its own for a volume or a
    /// mesh. Paths lead to the same files from there.
    std::string textFor(const std::filesystem::path& folder) const;

private:
    std::filesystem::path file_;
    std::vector<std::string> overrides_;
    Scene scene_;
    StageFields stages_;
};

} // namespace eikonal::window
