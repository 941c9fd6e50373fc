#pragma once
// How the rays of a tile become samples of the film: step by step (viewer/staged_pipeline.h), or where nothing but the index acts
// on them in one go (viewer/fused_pipeline.h).

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "common/inset_bricks.h"
#include "viewer/ray_batch.h"

namespace eikonal::viewer {

class RayPipeline {
public:
    virtual ~RayPipeline() = default;

    /// Sets what the kernels read of the settings.
    virtual void configure(gpu::ViewBlock& view) = 0;
    /// Arc length of a step, and longest piece on which matter is sampled once [voxels]. Throws badInput for a step that is not
    /// positive.
    virtual void setStep(double stepVoxels, double matterVoxels) = 0;
    virtual void setLens(bool hasLens) = 0;
    /// The same insets have moved.
    virtual void setInsets(const InsetBounds& insets) = 0;
    virtual void bind() const {}
    /// Begins the rays of a tile and follows them to the film. `mark`: told the name of each pass before it.
    virtual void run(RayBatch& batch, const std::function<void(std::string_view)>& mark) = 0;
    /// Instructions of the marching kernels, where the driver tells.
    virtual std::optional<std::size_t> instructions() = 0;
    /// Reflections followed so far.
    virtual std::uint64_t reflectedRays() const { return 0; }
    virtual std::size_t bytes() const { return 0; }
};

} // namespace eikonal::viewer
