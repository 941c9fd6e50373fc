#pragma once
// The environment as directional lights, more of them where it is brighter.

#include <vector>

#include "common/environment_map.h"

namespace eikonal {

/// At most `count` directional lights. The map is cut again and again: its brightest region, across the longer side, into
/// halves of equal power (median cut: P. Debevec, A Median Cut Algorithm for Light Probe Sampling, 2005). A light's
/// irradiance is the integral of radiance over its region's solid angle, so that their sum is the integral over the
/// sphere; it comes from the region's mean direction. Black regions give none.
std::vector<DirectionalLight> environmentLights(const EnvironmentCells& cells, int count);

} // namespace eikonal
