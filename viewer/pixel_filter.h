#pragma once
// Reconstruction filters of a pixel. Samples are spread by the filter's weight and then all count the same, so that a sample
// belongs to one pixel: nothing is scattered to neighbours, and sums need no order (M. Ernst, M. Stamminger, G. Greiner,
// Filter Importance Sampling, 2006).

#include "common/scene.h"

namespace eikonal::viewer {

/// The scene's, or that of the filter: box 1, tent 2, gaussian 2.5 (five sigmas), blackman-harris 3, edge to edge [pixels].
double filterWidthOf(const RenderSettings& settings);

/// Share of the filter's weight, 0 to 1, before a place from -1 to 1 between the filter's edges.
double filterShareBefore(PixelFilter filter, double place);

/// Place from -1 to 1 before which that share of the weight is, to 1e-15: the inverse of filterShareBefore.
double filterPlace(PixelFilter filter, double share);

} // namespace eikonal::viewer
