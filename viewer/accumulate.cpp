#include "viewer/accumulate.h"

namespace eikonal::viewer {

Accumulate::Accumulate(const gpu::Context& context, const std::vector<std::string>& defines)
    : kernel_(context, "viewer/accumulate.comp.glsl", defines), count_(context, "viewer/count.comp.glsl", defines), film_(context, 0, "film"),
      counters_(context, 8 * sizeof(std::uint32_t), "ray counts") {
    counters_.fill(0);
}

void Accumulate::reserve(const gpu::Context& context, std::size_t pixels) {
    const std::size_t bytes = pixels * sizeof(gpu::FilmPixel);
    if (film_.bytes() < bytes) film_ = gpu::RowBuffer(context, bytes, "film");
}

void Accumulate::bind() const {
    film_.bindStorage(gpu::kStorageFilm);
    film_.bindTexels(gpu::kUnitFilm);
    counters_.bindStorage(gpu::kStorageCounters);
}

void Accumulate::run(const RayBatch& batch) const {
    kernel_.dispatch(batch.groups());
    constexpr gpu::uint kRaysOfAGroup = gpu::kRaysPerGroup * gpu::kRaysPerCount;
    count_.dispatch({(batch.view.rayCount + kRaysOfAGroup - 1) / kRaysOfAGroup, 1, 1});
}

void Accumulate::read(std::size_t first, std::span<gpu::FilmPixel> pixels) const {
    film_.downloadBytes(first * sizeof(gpu::FilmPixel), pixels.data(), pixels.size_bytes());
}

RayCounts Accumulate::counts() const {
    const auto words = counters_.download<std::uint32_t>(8);
    const auto count = [&](std::size_t i) { return words[2 * i] + (std::uint64_t(words[2 * i + 1]) << 32); };
    return {count(0), count(1), count(2), count(3)};
}

} // namespace eikonal::viewer
