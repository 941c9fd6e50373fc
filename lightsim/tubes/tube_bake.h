#pragma once
// The bake by ray tubes: batch after batch of cells of the launch grids, window after window of optical path.

#include <functional>

#include "lightsim/tubes/tube_batch.h"

namespace eikonal::bake {

class TubeBake {
public:
    TubeBake(const gpu::Context& context, const std::vector<std::string>& defines, const LaunchGrids& grids,
             const BakeSettings& settings, const TubeSettings& tubeSettings, std::uint32_t capacity, double finishedShare);

    /// Adds all light of the grids to the voxel layers [begin, end) of the sums; the ledger begins anew.
    void propagate(int begin, int end, const LightSums& sums, PatchCounts& counts,
                   const std::function<void(double)>& progress);

    const gpu::Buffer& ledger() const { return kernels_.ledger(); }
    std::size_t bytes() const { return kernels_.bytes(); }

private:
    bool bake(TubeBatch& batch, const CellRange& cells, const LightSums& sums, PatchCounts& counts,
              std::uint32_t& window);

    const LaunchGrids& grids_;
    std::uint32_t capacity_;
    std::uint32_t maxWindows_;
    double finishedShare_;
    TubeKernels kernels_;
};

} // namespace eikonal::bake
