#pragma once
// The bake by ray tubes: batch after batch of cells of the launch grids, window after window of optical path.

#include <optional>

#include "lightsim/light_method.h"
#include "lightsim/light_sums.h"
#include "lightsim/tubes/detail.h"
#include "lightsim/tubes/tube_batch.h"

namespace eikonal::bake {

/// Cells [first, first + count) of those of a path; deposits of windows before `firstDeposit` are in the sums.
struct CellRange {
    std::uint32_t first;
    std::uint32_t count;
    std::uint32_t firstDeposit = 0;
};

class TubeBake : public LightMethod {
public:
    TubeBake(const gpu::Context& context, const MethodPlan& plan, const BakeOptions& options, const LaunchGrids& grids,
             const BakeSettings& settings);

    void setFields(const gpu::Context& context, const Fields& fields) override;
    void setLights(const gpu::Context& context, const LaunchGrids& grids, const BakeSettings& settings) override;
    int layers() const override { return layers_; }
    void propagate(int begin, int end, const std::function<void(double)>& progress) override;
    void propagateInto(const LobeBins& bins, const std::function<void(double)>& progress) override;
    void read(const DenseGrid<float>& opaque, BakedLight& light) const override;
    PatchCounts counts() const override { return counts_; }
    const gpu::Buffer& ledger() const override { return kernels_.ledger(); }
    std::size_t bytes() const override {
        return kernels_.bytes() + sums_.bytes() + (detail_ ? detail_->bytes() : 0) + (eikonal_ ? eikonal_->bytes() : 0);
    }

private:
    void run(int begin, int end, const Deposits& deposits, const std::function<void(double)>& progress);
    ReflectedLight follow(const LightPath& path, const Deposits& deposits, const std::function<void(double)>& progress);
    void countBatch(const TubeBatch& batch, std::size_t cells);
    bool bake(TubeBatch& batch, const CellRange& cells, const Deposits& deposits, std::uint32_t& window);

    Accuracy accuracy_;
    const Fields& fields_;
    const LaunchGrids* grids_;
    BakeSettings settings_;
    std::uint32_t capacity_;
    int layers_;
    bool followsReflections_;
    std::optional<gpu::Texture3D> detail_;  ///< where the fields hold any
    TubeKernels kernels_;
    LightSums sums_;
    std::optional<EikonalDeposit> eikonal_;  ///< where asked for
    PatchCounts counts_;
};

} // namespace eikonal::bake
