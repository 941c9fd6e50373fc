#include "viewer/accumulate.h"

namespace eikonal::viewer {

Accumulate::Accumulate(const gpu::Context& context, std::size_t capacity)
    : kernel_(context, "viewer/accumulate.comp.glsl", {}),
      film_(context, capacity * sizeof(gpu::FilmPixel), "film"),
      counters_(context, 6 * sizeof(std::uint32_t), "ray counts") {
    counters_.fill(0);
}

void Accumulate::run(const RayBatch& batch) const {
    film_.bindStorage(gpu::kStorageFilm);
    counters_.bindStorage(gpu::kStorageCounters);
    kernel_.dispatch(batch.groups());
}

RayCounts Accumulate::counts() const {
    const auto words = counters_.download<std::uint32_t>(6);
    const auto count = [&](std::size_t i) { return words[2 * i] + (std::uint64_t(words[2 * i + 1]) << 32); };
    return {count(0), count(1), count(2)};
}

} // namespace eikonal::viewer
