#pragma once
// The bake by ray tubes: batch after batch of cells of the launch grids, window after window of optical path.

#include "lightsim/light_method.h"
#include "lightsim/light_sums.h"
#include "lightsim/tubes/tube_batch.h"

namespace eikonal::bake {

class TubeBake : public LightMethod {
public:
    /// Room for `capacity` rays.
    TubeBake(const gpu::Context& context, const MethodPlan& plan, std::uint32_t capacity, const LaunchGrids& grids,
             const BakeSettings& settings);

    void setLights(const gpu::Context& context, const LaunchGrids& grids, const BakeSettings& settings) override;
    int layers() const override { return layers_; }
    void propagate(int begin, int end, const std::function<void(double)>& progress) override;
    void propagateInto(const LobeBins& bins, const std::function<void(double)>& progress) override;
    void read(const DenseGrid<float>& opaque, BakedLight& light) const override;
    PatchCounts counts() const override { return counts_; }
    const gpu::Buffer& ledger() const override { return kernels_.ledger(); }
    std::size_t bytes() const override { return kernels_.bytes() + sums_.bytes(); }

private:
    void run(int begin, int end, const VoxelSums& sums, const std::function<void(double)>& progress);
    bool bake(TubeBatch& batch, const CellRange& cells, const VoxelSums& sums, std::uint32_t& window);

    Accuracy accuracy_;
    const Fields& fields_;
    const LaunchGrids* grids_;
    BakeSettings settings_;
    std::uint32_t capacity_;
    int layers_;
    TubeKernels kernels_;
    LightSums sums_;
    PatchCounts counts_;
};

} // namespace eikonal::bake
