#pragma once
// Rays step by step, each step a kernel of its own that takes all rays of the tile: generate, march, follow reflections, shade,
// accumulate.

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viewer/accumulate.h"
#include "viewer/count.h"
#include "viewer/generate.h"
#include "viewer/march.h"
#include "viewer/ray_pipeline.h"
#include "viewer/reflections.h"
#include "viewer/shade.h"

namespace eikonal::viewer {

class StagedPipeline : public RayPipeline {
public:
    /// `defines`: as of March but FOLLOW_REFLECTIONS, which `rules` add. `rays`: of a tile, at most.
    StagedPipeline(const gpu::Context& context, std::vector<std::string> defines, const MarchSettings& settings,
                   const Lattice& lattice, bool hasLens, const std::optional<ReflectionRules>& rules, std::size_t rays);

    void configure(gpu::ViewBlock& view) override;
    void setStep(double stepVoxels, double matterVoxels) override { steps_ = {stepVoxels, matterVoxels}; }
    void setLens(bool hasLens) override;
    void setInsets(const InsetBounds& insets) override;
    void bind() const override;
    void run(RayBatch& batch, const std::function<void(std::string_view)>& mark) override;
    std::optional<std::size_t> instructions() override { return march().instructions(); }
    std::uint64_t reflectedRays() const override { return reflections_ ? reflections_->count() : 0; }
    std::size_t bytes() const override { return reflections_ ? reflections_->bytes() : 0; }

private:
    March& march();

    const gpu::Context& context_;
    std::vector<std::string> defines_;
    MarchSettings settings_;
    Lattice lattice_;
    std::optional<Reflections> reflections_;
    Generate generate_;
    using Steps = std::pair<double, double>;   ///< of rays, between samples of matter [voxels]
    Steps steps_;
    std::map<Steps, March> marches_;
    Shade shade_;
    Accumulate accumulate_;
    Count count_;
};

} // namespace eikonal::viewer
