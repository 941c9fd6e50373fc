#include "lightsim/light_sums.h"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "common/depth.h"

namespace eikonal::bake {

namespace {

constexpr std::size_t kSumBytes = 2 * sizeof(std::uint32_t);
// A voxel with less free volume than this share has no irradiance: what little light its corner holds has no measure.
constexpr double kMinFreeShare = 1e-3;

} // namespace

int layersPerSlab(const Lattice& lattice, std::size_t blockBytes) {
    const std::size_t layerBytes = std::size_t(lattice.size.x) * std::size_t(lattice.size.y) * kSumBytes;
    return int(std::clamp<std::size_t>(blockBytes / layerBytes, 1, std::size_t(lattice.size.z)));
}

LightSums::LightSums(const gpu::Context& context, const Lattice& lattice, int layers, int bands)
    : bands_(bands), voxelsPerLayer_(std::size_t(lattice.size.x) * std::size_t(lattice.size.y)) {
    const std::size_t bytes = voxelsPerLayer_ * std::size_t(layers) * kSumBytes;
    for (const char* label : {"flux x", "flux y", "flux z"}) {
        flux_.emplace_back(context, bytes, label);
    }
    for (int band = 0; band < bands; ++band) {
        irradiance_.emplace_back(context, bytes, "irradiance " + std::to_string(band));
    }
}

void LightSums::clear() {
    for (gpu::Buffer& buffer : flux_) {
        buffer.fill(0);
    }
    for (gpu::Buffer& buffer : irradiance_) {
        buffer.fill(0);
    }
}

void LightSums::bind() const {
    for (std::size_t i = 0; i < flux_.size(); ++i) {
        flux_[i].bindStorage(GLuint(BAKE_FLUX_BINDING + i));
    }
    for (std::size_t i = 0; i < irradiance_.size(); ++i) {
        irradiance_[i].bindStorage(GLuint(BAKE_IRRADIANCE_BINDING + i));
    }
}

void LightSums::read(const BakeSettings& settings, const DenseGrid<float>& opaque, BakedLight& light) const {
    const double unit = depositUnit(settings, light.lattice);
    const std::size_t count = voxelsPerLayer_ * std::size_t(settings.slabEnd - settings.slabBegin);
    const std::size_t first = voxelsPerLayer_ * std::size_t(settings.slabBegin);
    std::vector<std::vector<std::uint32_t>> flux, power;
    for (const gpu::Buffer& buffer : flux_) {
        flux.push_back(buffer.download<std::uint32_t>(2 * count));
    }
    for (const gpu::Buffer& buffer : irradiance_) {
        power.push_back(buffer.download<std::uint32_t>(2 * count));
    }
    const auto sumOf = [](const std::vector<std::uint32_t>& words, std::size_t i) {
        return fixedPointValue(words[2 * i], words[2 * i + 1]);
    };
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) {
        const double freeShare = freeShareAt(opaque, first + i);
        glm::dvec3 sums(sumOf(power[0], i));
        double total = sums.x;
        if (bands_ == 3) {
            sums = {sums.x, sumOf(power[1], i), sumOf(power[2], i)};
            total = sums.x + sums.y + sums.z;
        }
        if (total > 0.0 && freeShare > kMinFreeShare) {
            const glm::dvec3 vector(sumOf(flux[0], i), sumOf(flux[1], i), sumOf(flux[2], i));
            light.irradiance.values[first + i] = sums * (unit / freeShare);
            light.lightDirection.values[first + i] = vector / std::max(total, glm::length(vector));
        }
    });
}

std::size_t LightSums::bytes() const {
    return flux_.front().bytes() * (flux_.size() + irradiance_.size());
}

} // namespace eikonal::bake
