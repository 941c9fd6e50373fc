#include "lightsim/deposit.h"

namespace eikonal::bake {

Deposit::Deposit(const gpu::Context& context, const std::vector<std::string>& defines)
    : interpolated_(context, "lightsim/deposit.comp.glsl", defines),
      corners_(context, "lightsim/deposit_corners.comp.glsl", defines) {}

void Deposit::add(const Wavefront& wavefront, const LightSums& sums) const {
    wavefront.bindPool();
    sums.bind();
    wavefront.dispatchOverPatches(interpolated_);
    wavefront.dispatchOverListedCorners(corners_);
}

} // namespace eikonal::bake
