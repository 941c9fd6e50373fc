#pragma once
// What each light contributes, for pictures that are balanced afterwards.

#include "lightsim/bake.h"

namespace eikonal {

/// One bake per light, and their sum in place of a bake of all of them. Statistics are sums too; `peak` and
/// `memoryBytes` are the largest.
BakeResult bakePerLight(LightSimulator& simulator, const LightSet& lights);

} // namespace eikonal
