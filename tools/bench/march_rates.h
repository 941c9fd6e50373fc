#pragma once
// How fast this device evaluates an index field along rays, beside how fast it could.

#include "common/effects.h"
#include "common/gpu/context.h"
#include "common/scene.h"

namespace eikonal::bench {

/// Work done, and the shortest time that it took.
struct Rate {
    double count = 0.0;    ///< fetches of the index, look-ups included
    double seconds = 0.0;
    double perSecond() const { return seconds > 0.0 ? count / seconds : 0.0; }
};

struct MarchRates {
    Rate fetches;    ///< dependent trilinear fetches and nothing else
    Rate stepping;   ///< the marching kernel with refraction only, a step at a time through everything
    Rate flying;     ///< the same with straight flights
    Rate image;      ///< an image with refraction only, flights included: a round of its samples, from camera to display
    double rays = 0.0;
};

/// Marches the camera's rays with refraction only, makes a picture of them, and lets them fetch along their first directions. Each
/// is done `repeats` times in turn, and the shortest time counts: what else the machine does can only lengthen it.
/// Throws badInput for a scene without an index that varies.
MarchRates measureMarchRates(const gpu::Context& context, const Scene& scene, const Fields& fields, int repeats);

} // namespace eikonal::bench
