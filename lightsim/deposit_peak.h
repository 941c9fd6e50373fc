#pragma once
// Deposit of the 2007 method, for comparison: a voxel keeps the largest irradiance that passes through it.

#include <array>
#include <vector>

#include "lightsim/deposit.h"

namespace eikonal::bake {

/// The largest irradiance by band, and the direction of the patch that has the largest sum over bands.
class PeakDeposit : public Deposit {
public:
    PeakDeposit(const gpu::Context& context, const std::vector<std::string>& defines, const Lattice& lattice, int layers,
                int bands);

    void clear() override;
    void add(const Wavefront& wavefront) const override;
    void read(const BakeSettings& settings, const DenseGrid<float>& opaque, BakedLight& light) const override;
    std::size_t bytes() const override;

private:
    std::size_t voxelsPerLayer_;
    gpu::Buffer sum_, direction_;
    std::vector<gpu::Buffer> bands_;  ///< three, or none where the sum is all there is
    std::array<gpu::Buffer, 2> passes_;
    gpu::Kernel kernel_;
};

} // namespace eikonal::bake
