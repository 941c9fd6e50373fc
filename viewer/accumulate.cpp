#include "viewer/accumulate.h"

namespace eikonal::viewer {

Accumulate::Accumulate(const gpu::Context& context, const std::vector<std::string>& defines, std::size_t capacity)
    : kernel_(context, "viewer/accumulate.comp.glsl", defines),
      film_(context, capacity * sizeof(gpu::FilmPixel), "film"),
      counters_(context, 4 * sizeof(std::uint32_t), "ray counts") {
    counters_.fill(0);
}

void Accumulate::run(const RayBatch& batch) const {
    film_.bindStorage(gpu::kStorageFilm);
    counters_.bindStorage(gpu::kStorageCounters);
    kernel_.dispatch(batch.groups());
}

RayCounts Accumulate::counts() const {
    const auto words = counters_.download<std::uint32_t>(4);
    return {words[0] + (std::uint64_t(words[1]) << 32), words[2] + (std::uint64_t(words[3]) << 32)};
}

} // namespace eikonal::viewer
