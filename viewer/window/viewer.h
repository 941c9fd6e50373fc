#pragma once
// The window on a scene: a person orbits it, drags its lights and changes its values, and the picture follows.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "common/fields.h"
#include "common/scene.h"
#include "lightsim/bake.h"
#include "viewer/window/response.h"

namespace eikonal::window {

struct ViewOptions {
    std::filesystem::path file;          ///< scene, volume or mesh
    std::vector<std::string> overrides;  ///< "key.path=value"; render.size is the window's
    std::filesystem::path script;        ///< recording to replay; empty: none
    std::filesystem::path record;        ///< where to write what is done; empty: nowhere
    std::filesystem::path shaders;       ///< folder that kernels are read from and watched in; empty: those in the program
    double frameSeconds = 0.033;         ///< what a frame may take while something moves
    std::string creator;                 ///< that written images name
    std::function<void(const std::string&)> print;  ///< a line for the person: the camera, what was saved
    std::function<void(const std::string&)> warn;   ///< what an event of the script asked for in vain, beside the window's message
    /// Writes the light of a scene to a file. May throw Error.
    std::function<void(const std::filesystem::path&, const Scene&, const Fields&, const BakeResult&)> saveLight;
};

/// Opens the window and returns, with how quickly it answered, when it is closed. Throws Error(kNoDevice) without display or
/// OpenGL 4.5, badInput for a scene or recording that cannot be read.
ResponseRecord viewScene(const ViewOptions& options);

} // namespace eikonal::window
