#pragma once
// The picture in linear light, sample by sample, and what its rays cost. Kernels add to both (viewer/ray_pipeline.h).

#include <cstdint>
#include <span>

#include "common/gpu/row_buffer.h"
#include "shaders/shared/look_block.h"
#include "shaders/shared/view_blocks.h"

namespace eikonal::viewer {

/// Counts of all rays so far.
struct RayCounts {
    std::uint64_t entered = 0;      ///< rays that entered the domain
    std::uint64_t evaluations = 0;  ///< of the index field
    std::uint64_t lookUps = 0;      ///< of the clearance ahead
    std::uint64_t matterSamples = 0;  ///< of absorption, scattering and emission
};

class Film {
public:
    explicit Film(const gpu::Context& context);

    /// Room for that many pixels at least. What the film held may be gone.
    void reserve(const gpu::Context& context, std::size_t pixels);
    void bind() const;
    /// For kernels that compare another film with the one that is bound.
    void bindAsCompared() const { pixels_.bindTexels(gpu::kUnitComparedFilm); }
    /// Pixels of the film, the first one of which has that index.
    void read(std::size_t first, std::span<gpu::FilmPixel> pixels) const;
    RayCounts counts() const;
    std::size_t bytes() const { return pixels_.bytes(); }

private:
    gpu::RowBuffer pixels_;
    gpu::Buffer counters_;
};

} // namespace eikonal::viewer
