#pragma once
// The ray tubes of a launch mesh on the GPU: rays traced through a window of optical path, measured against each other,
// made to conform, deposited.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/gpu/row_buffer.h"
#include "common/lattice.h"
#include "lightsim/emit.h"
#include "lightsim/tubes/eikonal_deposit.h"
#include "lightsim/tubes/mirrors.h"
#include "lightsim/voxel_sums.h"
#include "shaders/shared/tube_blocks.h"

namespace eikonal::bake {

/// Where deposits go: light into sums or bins of its directions; the eikonal too, unless that is null.
struct Deposits {
    const VoxelSums& light;
    const EikonalDeposit* eikonal = nullptr;
};

class TubeKernels {
public:
    /// For at most `capacity` vertices, on a lattice; memory is taken as they come. Where reflections are followed, the kernels
    /// are other variants. Keeps a reference to the context.
    TubeKernels(const gpu::Context& context, const std::vector<std::string>& defines, const Lattice& lattice,
                std::uint32_t capacity, bool followsReflections);

    void setLights(const gpu::Context& context, const LaunchGrids& grids, const TubeSettings& tubeSettings);
    /// Counters and the ledger begin anew. The fields are bound.
    void restart(const BakeSettings& settings);
    /// The path that is followed from now on.
    void setMirrors(const Mirrors& mirrors);
    void beginWindow(std::uint32_t firstStep) { tubeSettings_.firstStep = firstStep; }

    /// For the vertices of a mesh, and as many nodes and edges as they can have.
    void makeRoomFor(std::size_t vertexCount);
    /// New vertices, not launched yet.
    void place(std::span<const TubePlacement> vertices);
    void placeNodes(std::uint32_t first, std::span<const TubeNode> nodes);
    void trace(std::span<const std::uint32_t> vertices);
    struct Measures {
        std::vector<TubeMeasure> edges, nodes;
    };
    Measures measure(std::span<const TubeEdge> edges, std::span<const std::uint32_t> nodes);
    void conform(std::span<const TubeConformity> conformities);
    /// Of all vertices, as their last trace left it.
    std::vector<TubePresence> presences(std::uint32_t count) const;
    /// Of all vertices; only where reflections are followed.
    std::vector<TubeReflections> reflections(std::uint32_t count) const { return reflections_.download<TubeReflections>(count); }
    /// Deposits nodes over steps.
    void deposit(std::span<const TubeJob> jobs, const Deposits& deposits);
    /// Enters the rays' stories in the ledger; power by vertex and band.
    void tally(std::span<const glm::vec4> powers);

    std::uint64_t fieldEvaluations() const;
    /// Cells over steps in which the wavefront turned inside out.
    std::uint64_t foldedCells() const;
    /// For readLedger; in units of BakeSettings::ledgerScale.
    const gpu::Buffer& ledger() const { return ledger_; }
    std::size_t bytes() const;

private:
    /// One for each list of parts.
    struct DepositKernels {
        gpu::Kernel gather, lines, rays;
        std::optional<gpu::Kernel> gatherInCut;  ///< where there is opaque matter

        DepositKernels(const gpu::Context& context, const std::vector<std::string>& defines);
    };

    void bindTracks() const;
    void run(const gpu::Kernel& kernel, std::size_t items, std::size_t invocationsPerItem = 1);
    static gpu::Kernel::Indirect listed(const gpu::Kernel& kernel, std::size_t list);
    void depositChunk(std::span<const TubeJob> jobs, const Deposits& deposits);
    const DepositKernels& depositKernels(const VoxelSums& sums);

    /// How work is divided into dispatches and invocations: a processor wants one invocation a part and what stays in its
    /// caches, a GPU many of both.
    struct Portions {
        int gathersPerPart;
        std::size_t jobs;             ///< that are deposited at a time
        std::uint32_t firstVertices;  ///< room for so many is made at once
    };
    static Portions portionsFor(const gpu::DeviceLimits& limits);

    template <class T>
    void uploadItems(std::span<const T> items) {
        items_.grow(items.size_bytes());
        items_.upload(items);
    }

    const gpu::Context& context_;
    Portions portions_;
    std::vector<std::string> defines_;
    std::uint32_t capacity_;
    bool followsReflections_;
    TubeSettings tubeSettings_{};
    gpu::Buffer vertices_, frames_, nodes_, items_, presences_, edgeMeasures_, nodeMeasures_, reflections_, parts_,
        freeSamples_, ledger_, settingsBlock_, tubeBlock_;
    gpu::RowBuffer positions_, shares_, cells_;
    gpu::Kernel place_, trace_, measureEdges_, measureNodes_, conform_, sortCells_, smoothCells_, sortParts_, tally_;
    std::optional<gpu::Kernel> countFreeSamples_;  ///< where there is opaque matter
    DepositKernels intoSums_;
    std::optional<DepositKernels> intoLobes_;  ///< compiled where they are first needed
};

} // namespace eikonal::bake
