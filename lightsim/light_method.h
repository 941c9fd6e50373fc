#pragma once
// A method to put the light of launch grids into a slab of voxel layers: patches as in 2007, or ray tubes.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/baked_light.h"
#include "common/fields.h"
#include "common/gpu/objects.h"
#include "lightsim/bake.h"
#include "lightsim/emit.h"
#include "lightsim/lobe_bins.h"

namespace eikonal::bake {

class LightMethod {
public:
    virtual ~LightMethod() = default;

    /// The fields from now on, on the lattice of those that it was made for: of another wavelength.
    virtual void setFields(const gpu::Context&, const Fields&) {}
    /// The lights from now on, and the settings that go with them; slabs aside.
    virtual void setLights(const gpu::Context& context, const LaunchGrids& grids, const BakeSettings& settings) = 0;
    /// Voxel layers of a slab; at least 1.
    virtual int layers() const = 0;
    /// Propagates all light and keeps what it leaves in the layers [begin, end); the ledger begins anew. Throws
    /// Error(kFailure) when interrupted.
    virtual void propagate(int begin, int end, const std::function<void(double fraction)>& progress) = 0;
    /// Propagates all light again, into bins of direction; counts and ledger as those of propagate.
    virtual void propagateInto(const LobeBins& bins, const std::function<void(double fraction)>& progress) = 0;
    /// Writes the slab's layers of the grids. `opaque` is empty or the depth in opaque matter: light is in the rest of
    /// the voxel.
    virtual void read(const DenseGrid<float>& opaque, BakedLight& light) const = 0;
    /// Of the last propagation.
    virtual PatchCounts counts() const = 0;
    /// For readLedger; in units of BakeSettings::ledgerScale.
    virtual const gpu::Buffer& ledger() const = 0;
    virtual std::size_t bytes() const = 0;
};

/// What a method is made for.
struct MethodPlan {
    const Fields& fields;
    const Accuracy& accuracy;
    std::vector<std::string> defines;
    int bands;
    std::size_t blockBytes;  ///< largest storage block
};

/// The method that `accuracy.deposit` asks for. setLights comes before propagate.
std::unique_ptr<LightMethod> makeMethod(const gpu::Context& context, const MethodPlan& plan, const BakeOptions& options,
                                        const LaunchGrids& grids, const BakeSettings& settings);

} // namespace eikonal::bake
