#pragma once
// The wavefront: a pool of patches on the GPU and the queue that says which are alive. Its rounds run without the CPU.

#include <cstdint>

#include "common/gpu/objects.h"
#include "common/gpu_fields.h"
#include "lightsim/emit.h"

namespace eikonal::bake {

/// Kernels of one round, each compiled for the effects of the scene.
class Wavefront {
public:
    Wavefront(const gpu::Context& context, const std::vector<std::string>& defines, const LaunchGrids& grids,
              const BakeSettings& settings);

    /// Other lights from now on; restart before the next round.
    void setGrids(const gpu::Context& context, const LaunchGrids& grids);

    /// Empties the pool and begins with the first cell of the launch grids; the ledger begins anew too.
    void restart(const BakeSettings& settings);

    void emit() const;       ///< fills free places of the pool from the lights
    void propagate() const;  ///< advances every corner one step
    void refine() const;     ///< retires, splits and keeps patches

    /// Binds what the deposit kernel reads.
    void bindPool() const;
    /// Dispatches a kernel with an invocation for each live patch.
    void dispatchOverPatches(const gpu::Kernel& kernel) const;
    /// Dispatches a kernel with an invocation for each corner of the patches listed for that.
    void dispatchOverListedCorners(const gpu::Kernel& kernel) const;

    QueueState state() const;
    /// The patches that refine has left alive, in no particular order.
    std::vector<WavefrontPatch> livePatches() const;
    /// Row by row, three bands each, in units of BakeSettings::ledgerScale.
    std::vector<double> ledger() const;
    std::size_t bytes() const;

private:
    void bindSources() const;

    std::uint32_t capacity_;
    gpu::Buffer patches_, queue_, frames_, records_, ledger_, settings_;
    gpu::Kernel planEmission_, emit_, beginRound_, propagate_, refine_, retire_, split_;
};

/// A sum of two words, as kernels keep it (shaders/lightsim/fixed_point.glsl).
inline double fixedPointValue(std::uint32_t low, std::uint32_t high) {
    return double(std::int64_t((std::uint64_t(high) << 32) | low));
}

} // namespace eikonal::bake
