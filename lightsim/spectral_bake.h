#pragma once
// A bake where something disperses: light of every band bends by an index field of its own, and is baked on its own.

#include <functional>
#include <vector>

#include "common/spectrum.h"
#include "lightsim/bake.h"

namespace eikonal::bake {

/// Throws badInput for what is not known by band: lobes that were asked for, and the eikonal.
void requireKnownByBand(const Scene& scene, const EffectSet& effects, const BakeOptions& options);

/// A bake through the fields of one band, of grey lights, which are the same in all components. `band` counts from 0.
using BandRun = std::function<BakeResult(const Fields& fields, const LightSet& lights, std::size_t band)>;

/// One run per band, and the linear Rec.709 that they add up to; their grids too where there are more than three. Lights
/// that have nothing in a band's channel make its run empty. `light_direction` is the sum of fluxes over that of irradiances.
BakeResult bakeSpectrum(const Fields& fields, const LightSet& lights, const std::vector<SpectralBand>& bands,
                        const BandRun& run);

} // namespace eikonal::bake
