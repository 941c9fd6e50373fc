#pragma once
// Second step: rays through the domain, in slices of bounded length that end where something happens to a ray. The first slice
// ends before any such step, which are rare; the others take it first. Where nothing but the index acts on rays, one kernel
// takes all slices.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/inset_bricks.h"
#include "common/lattice.h"
#include "common/scene.h"
#include "viewer/portions.h"
#include "viewer/ray_batch.h"

namespace eikonal::viewer {

struct MarchSettings {
    double stepVoxels = 1.0;           ///< arc length of a step [voxels]
    double matterVoxels = 1.0;         ///< longest piece on which matter that varies is sampled once [voxels]
    Integrator integrator = Integrator::kLeapfrog;
    std::uint32_t maxEvaluations = 0;  ///< and look-ups, by ray; 0: eight times the domain's diagonal, at least 4096
    std::uint32_t stepsPerSlice = 0;   ///< of one dispatch; 0: as many as the device likes
    InsetBounds insets{};              ///< of the fields, in whose finest voxels steps may have to be taken
};

class March {
public:
    /// `defines`: effects, BAKED_LIGHT, LIGHT_LOBES, ENVIRONMENT_IMAGE, STRAIGHT_FLIGHTS, FOLLOW_REFLECTIONS,
    /// MANUAL_FILTERING, INSETS. Throws badInput for a step that is not positive.
    March(const gpu::Context& context, const std::vector<std::string>& defines, const MarchSettings& settings,
          const Lattice& lattice);

    /// The same insets have moved.
    void setInsets(const InsetBounds& insets);
    /// Sets what the kernel reads of the settings.
    void configure(gpu::ViewBlock& view) const;
    /// Follows the rays on the list that was filled to their ends.
    void run(RayBatch& batch) const;
    /// Follows them by one slice, the first being 0; the list then holds those that go on.
    void runSlice(RayBatch& batch, std::uint32_t slice) const;
    /// Of its kernels, where the driver tells.
    std::optional<std::size_t> instructions() const;
    /// Slices in which every ray comes to its end.
    std::uint32_t mostSlices() const { return 2 * maxEvaluations_; }

private:
    std::vector<std::string> defines_;
    MarchSettings settings_;
    Lattice lattice_;
    Portions portions_;
    std::uint32_t maxEvaluations_ = 0;
    std::uint32_t stepsPerSlice_ = 0;
    std::optional<gpu::Kernel> first_;  ///< none where `onward_` takes the first slice too
    gpu::Kernel onward_;
};

} // namespace eikonal::viewer
