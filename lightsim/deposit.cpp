#include "lightsim/deposit.h"

#include "lightsim/deposit_peak.h"

namespace eikonal::bake {

SplatDeposit::SplatDeposit(const gpu::Context& context, const std::vector<std::string>& defines, const Lattice& lattice,
                           int layers, int bands)
    : Deposit(layers), sums_(context, lattice, layers, bands), splat_(context, defines) {}

Splat::Splat(const gpu::Context& context, const std::vector<std::string>& defines)
    : interpolated_(context, "lightsim/deposit.comp.glsl", defines),
      corners_(context, "lightsim/deposit_corners.comp.glsl", defines) {}

void Splat::add(const Wavefront& wavefront, const VoxelSums& sums) const {
    wavefront.bindPool();
    sums.bind();
    wavefront.dispatchOverPatches(interpolated_);
    wavefront.dispatchOverListedCorners(corners_);
}

std::unique_ptr<Deposit> makeDeposit(eikonal::Deposit method, const gpu::Context& context,
                                     const std::vector<std::string>& defines, const Lattice& lattice,
                                     std::size_t blockBytes, int bands) {
    const int layers = layersPerSlab(lattice, blockBytes);
    if (method == eikonal::Deposit::kPeak) {
        return std::make_unique<PeakDeposit>(context, defines, lattice, layers, bands);
    }
    return std::make_unique<SplatDeposit>(context, defines, lattice, layers, bands);
}

} // namespace eikonal::bake
