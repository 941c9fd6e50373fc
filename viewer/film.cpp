#include "viewer/film.h"

namespace eikonal::viewer {

Film::Film(const gpu::Context& context)
    : pixels_(context, 0, "film"), counters_(context, 8 * sizeof(std::uint32_t), "ray counts") {
    counters_.fill(0);
}

void Film::reserve(const gpu::Context& context, std::size_t pixels) {
    const std::size_t bytes = pixels * sizeof(gpu::FilmPixel);
    if (pixels_.bytes() < bytes) pixels_ = gpu::RowBuffer(context, bytes, "film");
}

void Film::bind() const {
    pixels_.bindStorage(gpu::kStorageFilm);
    pixels_.bindTexels(gpu::kUnitFilm);
    counters_.bindStorage(gpu::kStorageCounters);
}

void Film::read(std::size_t first, std::span<gpu::FilmPixel> pixels) const {
    pixels_.downloadBytes(first * sizeof(gpu::FilmPixel), pixels.data(), pixels.size_bytes());
}

RayCounts Film::counts() const {
    const auto words = counters_.download<std::uint32_t>(8);
    const auto count = [&](std::size_t i) { return words[2 * i] + (std::uint64_t(words[2 * i + 1]) << 32); };
    return {count(0), count(1), count(2), count(3)};
}

} // namespace eikonal::viewer
