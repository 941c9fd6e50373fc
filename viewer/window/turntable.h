#pragma once
// A turn around a scene as a sequence of images, without a window.

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace eikonal::window {

struct TurntableOptions {
    std::filesystem::path file;              ///< scene, volume or mesh
    std::vector<std::string> overrides;      ///< "key.path=value"
    int frames = 1;                          ///< of the whole turn
    std::function<std::string(int)> nameOf;  ///< file of a frame, counted from 0
    std::string creator;                     ///< that written images name
    std::function<void(std::string_view stage, double fraction)> progress;  ///< may throw to stop
};

/// Bakes the light once and writes a refined image for each camera. Throws as loadScene, bakeScene and writeRendered.
void writeTurntable(const TurntableOptions& options);

} // namespace eikonal::window
