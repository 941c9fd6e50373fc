#pragma once
// Lobes of baked light: which voxels need several, and how they come about. The light's moments tell a voxel in which
// directions cross: there |F| < E. A second propagation sorts the light of those voxels into bins of direction, and bins
// are merged.

#include <functional>

#include "common/effects.h"
#include "common/fields.h"
#include "common/scene.h"
#include "lightsim/light_method.h"

namespace eikonal::bake {

/// What decides on lobes.
class LobeCriterion {
public:
    LobeCriterion(const Accuracy& accuracy, const Fields& fields, const EffectSet& effects);

    /// Voxels whose light one direction may not stand for, ascending; none if no lobes are asked for. `auto` goes by the most
    /// that the moments allow.
    std::vector<std::uint32_t> voxelsOf(const BakedLight& light) const;
    /// Whether lobes are to be kept: for `auto`, if what the voxel scatters along one of them or along their mean differs from
    /// what their mean scatters by more than the tolerance of the most that the voxel could scatter in any direction.
    bool isToBeKept(std::size_t voxel, const std::vector<DirectedLight>& lobes) const;
    /// The share of a voxel's Σ|F| that a merger of lobes may lose. `lobes` keeps what is more than rounding; `auto` what
    /// makes a difference of more than the tolerance to what the voxel scatters forwards.
    double mergeTolerance(std::size_t voxel) const;

private:
    Directional directional_;
    double tolerance_;
    const Fields& fields_;
};

/// What the second propagation needs to know of the first.
struct LobePlan {
    const Fields& fields;
    double depositUnit;      ///< irradiance of one unit of the sums in a free voxel
    int bands;
    std::size_t blockBytes;  ///< largest storage block
};

/// The lobes of those voxels of `light` that need several. Propagates again, more than once if the bins of all of them exceed
/// a storage block; throws as LightMethod::propagate.
LobeTable lobesOf(const gpu::Context& context, LightMethod& method, const LobeCriterion& criterion, const LobePlan& plan,
                  const BakedLight& light, const std::function<void(double)>& progress);

/// The same for a light that is the sum of others, from their lobes.
LobeTable summedLobes(const LobeCriterion& criterion, const std::vector<NamedLight>& parts, const BakedLight& sum);

} // namespace eikonal::bake
