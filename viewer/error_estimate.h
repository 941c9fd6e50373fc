#pragma once
// What an image is off by, estimated from a regular sample of its pixels that is rendered again: with half the step, with cubic
// interpolation, with more samples.

#include "common/baked_light.h"
#include "common/effects.h"
#include "common/gpu/context.h"
#include "viewer/render_options.h"

namespace eikonal {

/// Root mean squares over pixels and bands, relative to the mean radiance.
struct ErrorEstimate {
    double total = 0.0;          ///< of the parts below, which have nothing to do with each other
    double step = 0.0;           ///< of the length of steps: by halving them, and the integrator's order
    double interpolation = 0.0;  ///< of linear interpolation: against cubic; 0 where the image has that already
    double sampling = 0.0;       ///< of the number of samples in a pixel: against four times as many, 16 at least
    std::size_t pixels = 0;      ///< that were rendered again
    double seconds = 0.0;        ///< that it took
};

/// Of an image by renderScene with the same arguments. What the light of the bake is off by is not in it. Looks at
/// one pixel in 64, 1024 to 2048 of them, with 3 rays for each of the image's and those of more samples. Throws as renderScene.
ErrorEstimate estimateError(const gpu::Context& context, const Scene& scene, const Fields& fields, const EffectSet& effects,
                            const BakedLight* bake, RenderOptions options = {});

} // namespace eikonal
