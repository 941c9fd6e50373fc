#pragma once
// In what steps rays are followed, how far at most, and how far in one dispatch.

#include <cstdint>
#include <string>
#include <vector>

#include "common/gpu/context.h"
#include "common/inset_bricks.h"
#include "common/lattice.h"
#include "common/scene.h"
#include "shaders/shared/view_blocks.h"
#include "viewer/portions.h"

namespace eikonal::viewer {

struct MarchSettings {
    double stepVoxels = 1.0;           ///< arc length of a step [voxels]
    double matterVoxels = 1.0;         ///< longest piece on which matter that varies is sampled once [voxels]
    Integrator integrator = Integrator::kLeapfrog;
    std::uint32_t maxEvaluations = 0;  ///< and look-ups, by ray; 0: eight times the domain's diagonal, at least 4096
    std::uint32_t stepsPerSlice = 0;   ///< of one dispatch; 0: as many as the device likes
    InsetBounds insets{};              ///< of the fields, in whose finest voxels steps may have to be taken
};

class MarchLimits {
public:
    /// `defines`: those that rays are marched with. Throws badInput for a step that is not positive.
    MarchLimits(const gpu::Context& context, std::vector<std::string> defines, const MarchSettings& settings,
                const Lattice& lattice);

    /// The same insets have moved.
    void setInsets(const InsetBounds& insets);
    /// Sets what kernels read of them.
    void configure(gpu::ViewBlock& view) const;
    /// Slices in which every ray comes to its end.
    std::uint32_t mostSlices() const { return 2 * maxEvaluations_; }

private:
    std::vector<std::string> defines_;
    MarchSettings settings_;
    Lattice lattice_;
    Portions portions_;
    std::uint32_t maxEvaluations_ = 0;
    std::uint32_t stepsPerSlice_ = 0;
};

/// With what a kernel takes steps so.
std::vector<std::string> stepDefines(const MarchSettings& settings);

/// Whether rays bend and nothing else happens to them, in steps that shaders/viewer/free_steps.glsl knows.
bool stepsFreely(const std::vector<std::string>& defines, Integrator integrator);

} // namespace eikonal::viewer
