#pragma once
// Rays that boundaries reflect, and those that these meet boundaries with: marched and shaded like rays from the camera, round
// after round, a pixel's one at a time (shaders/viewer/reflect.comp.glsl).

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "common/effects.h"
#include "viewer/march.h"
#include "viewer/ray_batch.h"
#include "viewer/shade.h"

namespace eikonal::viewer {

/// Which reflections are followed.
struct ReflectionRules {
    int generations = 0;      ///< mirrors on a ray's way from the camera, at most
    double tolerance = 0.02;  ///< the scene's, of which a share is too weak to follow
};

class Reflections {
public:
    /// `defines`: those of the fields. `capacity`: rays of a batch.
    Reflections(const gpu::Context& context, const std::vector<std::string>& defines, const ReflectionRules& rules,
                std::size_t capacity);

    /// Where boundaries mirror more than an untinted environment.
    static bool areNeeded(const EffectSet& effects, int generations);

    void configure(gpu::ViewBlock& view) const;
    /// "FOLLOW_REFLECTIONS", with which the march is compiled.
    static std::vector<std::string> defines() { return {"FOLLOW_REFLECTIONS"}; }
    /// Where the march notes what it meets. To be bound before rays are generated.
    void bind() const;
    /// Follows all that the marched rays of a batch have met, and adds what it shows to them. They must not be shaded yet.
    void run(RayBatch& batch, const March& march, const Shade& shade);
    /// A round of that without shading: marches a reflection of every ray at which one waits. False where none does.
    bool marchRound(RayBatch& batch, const March& march);
    /// The rays of the round, in the batch's order; kNoRay: none.
    std::vector<gpu::RayState> states(const RayBatch& batch) const;
    /// Reflections followed so far.
    std::uint64_t count() const { return count_; }
    std::size_t bytes() const { return rays_.bytes() + waiting_.bytes(); }

private:
    ReflectionRules rules_;
    gpu::Kernel kernel_;
    gpu::RowBuffer rays_;
    gpu::Buffer waiting_;
    std::uint64_t count_ = 0;
};

} // namespace eikonal::viewer
