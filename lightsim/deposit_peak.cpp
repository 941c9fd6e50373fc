#include "lightsim/deposit_peak.h"

#include <bit>

namespace eikonal::bake {

namespace {

gpu::Buffer passBuffer(const gpu::Context& context, std::uint32_t pass) {
    gpu::Buffer buffer(context, sizeof(PeakPass), "bake peak pass");
    buffer.upload(PeakPass{pass, 0, 0, 0});
    return buffer;
}

glm::vec3 directionOf(std::uint32_t word) {
    if (word == 0u) {
        return glm::vec3(0.0f);
    }
    const glm::ivec3 steps(word & 1023u, (word >> 10) & 1023u, word >> 20);
    return glm::normalize(glm::vec3(steps - PEAK_DIRECTION_STEPS));
}

} // namespace

PeakDeposit::PeakDeposit(const gpu::Context& context, const std::vector<std::string>& defines, const Lattice& lattice,
                         int layers, int bands)
    : Deposit(layers), voxelsPerLayer_(std::size_t(lattice.size.x) * std::size_t(lattice.size.y)),
      sum_(context, voxelsPerLayer_ * std::size_t(layers) * sizeof(std::uint32_t), "largest irradiance"),
      direction_(context, sum_.bytes(), "direction of the largest irradiance"),
      passes_{passBuffer(context, PEAK_RAISE), passBuffer(context, PEAK_DIRECT)},
      kernel_(context, "lightsim/deposit_peak.comp.glsl", defines) {
    for (int band = 0; bands == 3 && band < bands; ++band) {
        bands_.emplace_back(context, sum_.bytes(), "largest irradiance " + std::to_string(band));
    }
}

void PeakDeposit::clear() {
    sum_.fill(0);
    direction_.fill(0);
    for (gpu::Buffer& buffer : bands_) {
        buffer.fill(0);
    }
}

void PeakDeposit::add(const Wavefront& wavefront) const {
    wavefront.bindPool();
    sum_.bindStorage(BAKE_PEAK_SUM_BINDING);
    direction_.bindStorage(BAKE_PEAK_DIRECTION_BINDING);
    for (std::size_t i = 0; i < bands_.size(); ++i) {
        bands_[i].bindStorage(GLuint(BAKE_IRRADIANCE_BINDING + i));
    }
    for (const gpu::Buffer& pass : passes_) {
        pass.bindUniform(BAKE_PEAK_PASS_BINDING);
        wavefront.dispatchOverPatches(kernel_);
    }
}

void PeakDeposit::read(const BakeSettings& settings, const DenseGrid<float>&, BakedLight& light) const {
    const std::size_t count = voxelsPerLayer_ * std::size_t(settings.slabEnd - settings.slabBegin);
    const std::size_t first = voxelsPerLayer_ * std::size_t(settings.slabBegin);
    const auto sums = sum_.download<std::uint32_t>(count);
    const auto directions = direction_.download<std::uint32_t>(count);
    std::vector<std::vector<std::uint32_t>> byBand;
    for (const gpu::Buffer& buffer : bands_) {
        byBand.push_back(buffer.download<std::uint32_t>(count));
    }
    for (std::size_t i = 0; i < count; ++i) {
        const auto bandAt = [&](std::size_t band) { return std::bit_cast<float>(byBand[band][i]); };
        light.irradiance.values[first + i] =
            byBand.empty() ? glm::vec3(std::bit_cast<float>(sums[i])) : glm::vec3(bandAt(0), bandAt(1), bandAt(2));
        light.lightDirection.values[first + i] = directionOf(directions[i]);
    }
}

std::size_t PeakDeposit::bytes() const { return sum_.bytes() * (2 + bands_.size()); }

} // namespace eikonal::bake
