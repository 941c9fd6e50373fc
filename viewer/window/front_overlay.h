#pragma once
// A wavefront's patches drawn over the picture.

#include <vector>

#include "common/scene.h"
#include "lightsim/front.h"

namespace eikonal::window {

/// Patches that are folded in another colour; the brighter their irradiance beside the median, the less transparent.
void drawFront(const std::vector<FrontPatch>& front, const Camera& camera);

} // namespace eikonal::window
