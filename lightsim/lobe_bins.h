#pragma once
// Light of listed voxels by bins of direction, on the device (shaders/lightsim/lobe_bins.glsl).

#include <cstdint>
#include <span>
#include <vector>

#include "common/gpu/objects.h"
#include "lightsim/merge_lobes.h"
#include "lightsim/voxel_sums.h"
#include "shaders/shared/bake_blocks.h"

namespace eikonal::bake {

/// A stretch of the list of voxels that is binned in one pass.
struct LobeTile {
    std::size_t first, count;  ///< of the list
    int slabBegin, slabEnd;    ///< the layers that hold them
};

/// Cuts a list of voxels, ascending, into tiles whose bins fit into a storage block of `blockBytes`.
std::vector<LobeTile> lobeTiles(std::span<const std::uint32_t> voxels, const Lattice& lattice, std::size_t blockBytes);

/// Sums for the voxels of a tile.
class LobeBins : public VoxelSums {
public:
    /// `unitsOfVoxel`: what each voxel of the list gets in all, over bands that are told apart, in units of the deposit.
    LobeBins(const gpu::Context& context, std::span<const std::uint32_t> voxels, std::span<const double> unitsOfVoxel,
             const LobeTile& tile, const Lattice& lattice, int bands);

    void bind() const override;
    bool areLobes() const override { return true; }
    const LobeTile& tile() const { return tile_; }
    /// Light by direction of each voxel of the tile, in any unit.
    std::vector<std::vector<DirectedLight>> read() const;

private:
    LobeTile tile_;
    int bands_;
    gpu::Buffer rows_, scales_, powers_, fluxes_;
};

} // namespace eikonal::bake
