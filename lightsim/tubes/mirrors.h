#pragma once
// Which light is followed from which mirrors: every path is a run of the bake of its own, begun where the run before it
// found power reflected.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lightsim/emit.h"
#include "lightsim/tubes/launch_mesh.h"

namespace eikonal::bake {

/// The crossings of boundaries at which a path is reflected, in order; each counted from 0 behind the mirror before it.
using Mirrors = std::vector<std::uint32_t>;

/// As kernels read it (TubeSettings::mirrors).
std::uint32_t packed(const Mirrors& mirrors);

/// Light of some cells of the launch grids that is followed from its last mirror on; without mirrors, from the source.
struct LightPath {
    Mirrors mirrors;
    std::vector<std::uint32_t> cells;
};

/// All light from the source on.
LightPath pathFromSource(const LaunchGrids& grids);

/// Power that crossing after crossing reflects, strongest band.
using PowerByCrossing = std::array<double, TUBE_CROSSINGS>;

/// By root cell of a mesh; `reflections` by vertex, of those that are rays. Each corner of a leaf's sub-cell stands for a
/// quarter of its power.
std::vector<PowerByCrossing> reflectedByRoot(const LaunchMesh& mesh, const LaunchGrids& grids,
                                             std::span<const TubeReflections> reflections, std::size_t rootCount);

/// What the light of one path loses by reflection.
class ReflectedLight {
public:
    /// Of cells of the launch grids.
    void add(std::span<const std::uint32_t> cells, std::span<const PowerByCrossing> powers);
    /// The paths with one mirror more that carry at least `leastPower`.
    std::vector<LightPath> pathsBehind(const Mirrors& mirrors, double leastPower) const;

private:
    PowerByCrossing power_{};
    std::array<std::vector<std::uint32_t>, TUBE_CROSSINGS> cells_;
};

} // namespace eikonal::bake
