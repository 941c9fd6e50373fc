#include "viewer/window/coarse_scene.h"

#include <algorithm>

namespace eikonal::window {

Scene coarse(Scene scene) {
    scene.domain.resolution = std::min(scene.domain.resolution, kCoarseResolution);
    scene.accuracy.tolerance = std::max(scene.accuracy.tolerance, kCoarseTolerance);
    return scene;
}

bool isCoarse(const Scene& scene) {
    return scene.domain.resolution <= kCoarseResolution && scene.accuracy.tolerance >= kCoarseTolerance;
}

} // namespace eikonal::window
