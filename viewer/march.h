#pragma once
// Second step: rays through the domain, in slices of bounded length that end where something happens to a ray. The first slice
// ends before any such step, which are rare; the others take it first. Where nothing but the index acts on rays, one kernel
// takes all slices.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "viewer/march_limits.h"
#include "viewer/ray_batch.h"

namespace eikonal::viewer {

class March {
public:
    /// `defines`: effects, BAKED_LIGHT, LIGHT_LOBES, ENVIRONMENT_IMAGE, STRAIGHT_FLIGHTS, FOLLOW_REFLECTIONS,
    /// MANUAL_FILTERING, INSETS. Throws badInput for a step that is not positive.
    March(const gpu::Context& context, const std::vector<std::string>& defines, const MarchSettings& settings,
          const Lattice& lattice);

    /// The same insets have moved.
    void setInsets(const InsetBounds& insets) { limits_.setInsets(insets); }
    /// Sets what the kernel reads of the settings.
    void configure(gpu::ViewBlock& view) const { limits_.configure(view); }
    /// Follows the rays on the list that was filled to their ends.
    void run(RayBatch& batch) const;
    /// Follows them by one slice, the first being 0; the list then holds those that go on.
    void runSlice(RayBatch& batch, std::uint32_t slice) const;
    /// Of its kernels, where the driver tells.
    std::optional<std::size_t> instructions() const;
    /// Slices in which every ray comes to its end.
    std::uint32_t mostSlices() const { return limits_.mostSlices(); }

private:
    MarchLimits limits_;
    std::optional<gpu::Kernel> first_;  ///< none where `onward_` takes the first slice too
    gpu::Kernel onward_;
};

} // namespace eikonal::viewer
