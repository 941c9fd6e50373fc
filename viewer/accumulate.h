#pragma once
// Fourth step: samples into the film, and counts.

#include <cstdint>
#include <span>

#include "shaders/shared/look_block.h"
#include "viewer/ray_batch.h"

namespace eikonal::viewer {

/// Counts of all rays so far.
struct RayCounts {
    std::uint64_t entered = 0;      ///< rays that entered the domain
    std::uint64_t evaluations = 0;  ///< of the index field
    std::uint64_t lookUps = 0;      ///< of the clearance ahead
    std::uint64_t matterSamples = 0;  ///< of absorption, scattering and emission
};

class Accumulate {
public:
    Accumulate(const gpu::Context& context, const std::vector<std::string>& defines);

    /// Room for that many pixels at least. What the film held may be gone.
    void reserve(const gpu::Context& context, std::size_t pixels);
    void bind() const;
    /// For kernels that compare another film with the one that is bound.
    void bindAsCompared() const { film_.bindTexels(gpu::kUnitComparedFilm); }
    void run(const RayBatch& batch) const;
    /// Pixels of the film, the first one of which has that index.
    void read(std::size_t first, std::span<gpu::FilmPixel> pixels) const;
    RayCounts counts() const;
    std::size_t filmBytes() const { return film_.bytes(); }

private:
    gpu::Kernel kernel_, count_;
    gpu::RowBuffer film_;
    gpu::Buffer counters_;
};

} // namespace eikonal::viewer
