#pragma once
// A batch of cells of the launch grids, followed from the source until their light has left the domain.

#include <vector>

#include "common/lattice.h"
#include "lightsim/emit.h"
#include "lightsim/tubes/launch_mesh.h"
#include "lightsim/tubes/tube_kernels.h"

namespace eikonal::bake {

class TubeBatch {
public:
    /// `cells`: numbers among those of all launch grids.
    TubeBatch(TubeKernels& kernels, const LaunchGrids& grids, const Lattice& domain, std::span<const std::uint32_t> cells,
              std::uint32_t capacity);

    void begin(std::uint32_t window);  ///< of optical path
    void propagate();                  ///< all rays through the window
    /// Until the window is resolved. False: a batch of several cells needs more rays than there is room for.
    bool refine();
    void conform();                    ///< closes gaps between nodes of different size
    std::uint64_t deposit(const Deposits& deposits);  ///< returns the number of patch-steps
    /// Ends the cells that have less than this share of their power left in the domain. True: all have ended.
    bool isFinished(double share);
    void tally();
    /// What the cells have lost by reflection; only where reflections are followed.
    std::vector<PowerByCrossing> reflected() const;

    std::uint32_t vertexCount() const { return std::uint32_t(mesh_.vertices.size()); }
    std::uint32_t refusedHalvings() const { return mesh_.refusedHalvings(); }
    std::uint32_t nodeCount() const { return std::uint32_t(mesh_.nodes.size()); }

private:
    bool markAlive(std::uint32_t node);
    void placeNew();
    void traceNew(const std::vector<std::uint32_t>& edges, std::uint32_t firstNode);
    void measure(const std::vector<std::uint32_t>& edges, const std::vector<std::uint32_t>& nodes);
    void conformFrom(std::uint32_t firstVertex, bool withRays);
    void listJobs(std::uint32_t node, Samples steps, std::vector<TubeJob>& jobs) const;
    Samples stepsNear(std::uint32_t node) const;
    Samples bentSteps(std::uint32_t node) const;
    void findBends();

    TubeKernels& kernels_;
    const LaunchGrids& grids_;
    const Lattice& domain_;
    std::uint32_t capacity_;
    LaunchMesh mesh_;
    std::uint32_t rootCount_;
    std::uint32_t placedVertices_ = 0, placedNodes_ = 0;
    std::vector<std::uint8_t> isActive_;  ///< vertices that have a track in this window
    std::vector<std::uint8_t> hasEnded_;  ///< vertices
    std::vector<std::uint8_t> isDone_;    ///< roots
    std::vector<std::uint8_t> isAlive_;   ///< nodes
    std::vector<TubePresence> presences_;
    std::vector<Samples> bends_;          ///< steps at which a vertex does not go straight on
};

} // namespace eikonal::bake
