#pragma once
// Fourth step: samples into the film of a tile, and counts.

#include <cstdint>

#include "viewer/ray_batch.h"

namespace eikonal::viewer {

/// Counts of all rays so far.
struct RayCounts {
    std::uint64_t entered = 0;      ///< rays that entered the domain
    std::uint64_t evaluations = 0;  ///< of the index field
    std::uint64_t lookUps = 0;      ///< of the clearance ahead
};

class Accumulate {
public:
    Accumulate(const gpu::Context& context, std::size_t capacity);

    void run(const RayBatch& batch) const;
    /// The film of a tile of that many pixels.
    std::vector<gpu::FilmPixel> film(std::size_t pixels) const { return film_.download<gpu::FilmPixel>(pixels); }
    RayCounts counts() const;

private:
    gpu::Kernel kernel_;
    gpu::Buffer film_;
    gpu::Buffer counters_;
};

} // namespace eikonal::viewer
