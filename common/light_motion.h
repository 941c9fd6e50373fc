#pragma once
// Lights that move: where one is at a frame of a sequence.

#include "common/scene.h"

namespace eikonal {

bool hasPosition(const Light& light);
bool hasDirection(const Light& light);

const std::vector<LightKeyframe>& keyframesOf(const Light& light);
std::vector<LightKeyframe>& keyframesOf(Light& light);

/// The light as it stands at a frame, without keyframes. Positions are interpolated linearly between the keyframes that
/// have one, directions along the great circle; before the first and after the last they are held. What no keyframe says
/// stays as the light has it.
Light lightAt(const Light& light, double frame);

} // namespace eikonal
