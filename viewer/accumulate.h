#pragma once
// Fourth step: samples into the film, and counts.

#include <cstdint>

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
    /// The first pixels of the film.
    std::vector<gpu::FilmPixel> film(std::size_t pixels) const { return film_.download<gpu::FilmPixel>(pixels); }
    gpu::FilmPixel pixel(std::size_t index) const;
    RayCounts counts() const;
    std::size_t filmBytes() const { return film_.bytes(); }

private:
    gpu::Kernel kernel_, count_;
    gpu::RowBuffer film_;
    gpu::Buffer counters_;
};

} // namespace eikonal::viewer
