#pragma once
// Rays on which nothing but the index acts, from the camera to the film in one kernel: no state is written but of those that are
// under way at the end of a slice, and no kernel is begun for a step that takes less time than its beginning.

#include <optional>
#include <string>
#include <vector>

#include "viewer/march_limits.h"
#include "viewer/ray_pipeline.h"

namespace eikonal::viewer {

class FusedPipeline : public RayPipeline {
public:
    /// Whether it serves rays that are marched so.
    static bool serves(const std::vector<std::string>& defines, Integrator integrator);

    /// `defines`: as of March.
    FusedPipeline(const gpu::Context& context, std::vector<std::string> defines, const MarchSettings& settings,
                  const Lattice& lattice, bool hasLens);

    void configure(gpu::ViewBlock& view) override { limits().configure(view); }
    void setStep(double stepVoxels, double matterVoxels) override;
    void setLens(bool hasLens) override;
    void setInsets(const InsetBounds& insets) override { settings_.insets = insets; }
    void run(RayBatch& batch, const std::function<void(std::string_view)>& mark) override;
    std::optional<std::size_t> instructions() override;

private:
    MarchLimits limits() const { return {context_, defines_, settings_, lattice_}; }

    const gpu::Context& context_;
    std::vector<std::string> defines_;
    MarchSettings settings_;
    Lattice lattice_;
    gpu::uint blocksInTurn_;
    gpu::Kernel first_, onward_;
};

} // namespace eikonal::viewer
