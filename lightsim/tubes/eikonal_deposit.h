#pragma once
// Deposit of the eikonal: the least optical path from the lights to every voxel of a slab of layers.

#include <string>
#include <vector>

#include "common/gpu/objects.h"
#include "common/lattice.h"
#include "shaders/shared/tube_blocks.h"

namespace eikonal::bake {

class EikonalDeposit {
public:
    /// Room for `layers` voxel layers of a lattice.
    EikonalDeposit(const gpu::Context& context, const std::vector<std::string>& defines, const Lattice& lattice, int layers);

    void clear() { leastPaths_.fill(kNoPath); }
    /// Offers the paths of listed parts of cells, which are bound as for a deposit of light; so are the settings.
    void add(const gpu::Buffer& parts) const;
    /// Writes the layers [slabBegin, slabEnd) [scene units], kUnreached where no light has come.
    void read(const BakeSettings& settings, DenseGrid<float>& grid) const;
    std::size_t bytes() const { return leastPaths_.bytes(); }

private:
    static constexpr std::uint32_t kNoPath = 0xFFFFFFFFu;  // more than the bits of any path

    std::size_t voxelsPerLayer_;
    gpu::Buffer leastPaths_;
    std::vector<gpu::Kernel> kernels_;  ///< one for each list of parts
};

} // namespace eikonal::bake
