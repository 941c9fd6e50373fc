#pragma once
// Fixed-point sums of power × path length over a slab of voxel layers, and the grids that they make.

#include <vector>

#include "common/baked_light.h"
#include "common/fields.h"
#include "common/gpu/objects.h"
#include "lightsim/voxel_sums.h"
#include "shaders/shared/bake_blocks.h"

namespace eikonal::bake {

/// Sums for the voxel layers [begin, begin + layers) of a lattice; `layers` is bounded by the largest storage block.
class LightSums : public VoxelSums {
public:
    LightSums(const gpu::Context& context, const Lattice& lattice, int layers, int bands);

    void clear();
    void bind() const override;
    bool areLobes() const override { return false; }
    /// Writes the layers [slabBegin, slabEnd) of the grids. `opaque` is empty or the depth in opaque matter: light is in
    /// the rest of the voxel.
    void read(const BakeSettings& settings, const DenseGrid<float>& opaque, BakedLight& light) const;
    std::size_t bytes() const;

private:
    int bands_;
    std::size_t voxelsPerLayer_;
    std::vector<gpu::Buffer> flux_, irradiance_;
};

/// Irradiance that one unit of the sums is in a free voxel [power / scene unit²].
inline double depositUnit(const BakeSettings& settings, const Lattice& lattice) {
    return 1.0 / (double(settings.depositScale) * lattice.voxel * lattice.voxel);
}

/// Voxel layers whose sums fit in a storage block of `blockBytes`; at least 1.
int layersPerSlab(const Lattice& lattice, std::size_t blockBytes);

/// A sum of two words, as kernels keep it (shaders/lightsim/fixed_point.glsl).
inline double fixedPointValue(std::uint32_t low, std::uint32_t high) {
    return double(std::int64_t((std::uint64_t(high) << 32) | low));
}

} // namespace eikonal::bake
