#pragma once
// Deposit: patches leave power × path length in the voxels that they sweep.

#include "lightsim/light_sums.h"
#include "lightsim/wavefront.h"

namespace eikonal::bake {

class Deposit {
public:
    Deposit(const gpu::Context& context, const std::vector<std::string>& defines);

    /// Adds the last step of every live patch.
    void add(const Wavefront& wavefront, const LightSums& sums) const;

private:
    gpu::Kernel interpolated_, corners_;
};

} // namespace eikonal::bake
