#include "lightsim/lobe_bins.h"

#include <algorithm>

namespace eikonal::bake {

namespace {

// A voxel's whole light in a word's units: a quarter of what a word with a sign holds. Flux is not rounded to the deposit's
// units, as power is: up to half a unit a band, of one at least, is 2.5 times as much at worst.
constexpr double kUnitsOfWhole = double(1 << 29);

std::size_t rowBytes(int words) { return std::size_t(LOBE_BINS) * std::size_t(words) * sizeof(std::int32_t); }

std::size_t voxelsPerLayer(const Lattice& lattice) { return std::size_t(lattice.size.x) * std::size_t(lattice.size.y); }

std::size_t voxelsOfSlab(const LobeTile& tile, const Lattice& lattice) {
    return voxelsPerLayer(lattice) * std::size_t(tile.slabEnd - tile.slabBegin);
}

/// Where bands are not told apart, a word of power stands for three, and flux is that of one.
DirectedLight lightOf(const std::int32_t* power, const glm::ivec3& flux, int bands) {
    if (bands == 3) {
        return {glm::dvec3(power[0], power[1], power[2]), glm::dvec3(flux)};
    }
    return {glm::dvec3(power[0]), 3.0 * glm::dvec3(flux)};
}

} // namespace

std::vector<LobeTile> lobeTiles(std::span<const std::uint32_t> voxels, const Lattice& lattice, std::size_t blockBytes) {
    const std::size_t mostRows = std::max<std::size_t>(1, blockBytes / rowBytes(3));
    const std::size_t layerBytes = voxelsPerLayer(lattice) * sizeof(std::uint32_t);
    const std::size_t mostLayers = std::max<std::size_t>(1, blockBytes / layerBytes);
    const auto layerOf = [&](std::size_t i) { return voxels[i] / voxelsPerLayer(lattice); };
    std::vector<LobeTile> tiles;
    for (std::size_t first = 0; first < voxels.size();) {
        std::size_t end = std::min(first + mostRows, voxels.size());
        while (layerOf(end - 1) - layerOf(first) >= mostLayers) {
            --end;
        }
        tiles.push_back({first, end - first, int(layerOf(first)), int(layerOf(end - 1)) + 1});
        first = end;
    }
    return tiles;
}

LobeBins::LobeBins(const gpu::Context& context, std::span<const std::uint32_t> voxels, std::span<const double> unitsOfVoxel,
                   const LobeTile& tile, const Lattice& lattice, int bands)
    : tile_(tile), bands_(bands), rows_(context, voxelsOfSlab(tile, lattice) * sizeof(std::uint32_t), "lobe rows"),
      scales_(context, tile.count * sizeof(float), "lobe scales"), powers_(context, tile.count * rowBytes(bands), "lobe powers"),
      fluxes_(context, tile.count * rowBytes(3), "lobe fluxes") {
    std::vector<std::uint32_t> rows(voxelsOfSlab(tile, lattice), 0);
    std::vector<float> scales(tile.count);
    const std::size_t firstVoxel = voxelsPerLayer(lattice) * std::size_t(tile.slabBegin);
    for (std::size_t row = 0; row < tile.count; ++row) {
        rows[voxels[tile.first + row] - firstVoxel] = std::uint32_t(row + 1);
        scales[row] = float(kUnitsOfWhole / unitsOfVoxel[tile.first + row]);
    }
    rows_.upload(std::span<const std::uint32_t>(rows));
    scales_.upload(std::span<const float>(scales));
    powers_.fill(0);
    fluxes_.fill(0);
}

void LobeBins::bind() const {
    rows_.bindStorage(BAKE_LOBE_ROWS_BINDING);
    scales_.bindStorage(BAKE_LOBE_SCALES_BINDING);
    powers_.bindStorage(BAKE_LOBE_POWERS_BINDING);
    fluxes_.bindStorage(BAKE_LOBE_FLUXES_BINDING);
}

std::vector<std::vector<DirectedLight>> LobeBins::read() const {
    const std::size_t bins = tile_.count * LOBE_BINS, bands = std::size_t(bands_);
    const auto powers = powers_.download<std::int32_t>(bins * bands);
    const auto fluxes = fluxes_.download<std::int32_t>(bins * 3);
    std::vector<std::vector<DirectedLight>> voxels(tile_.count);
    for (std::size_t bin = 0; bin < bins; ++bin) {
        const glm::ivec3 flux(fluxes[3 * bin], fluxes[3 * bin + 1], fluxes[3 * bin + 2]);
        const DirectedLight light = lightOf(&powers[bin * bands], flux, bands_);
        if (light.power() > 0.0) {
            voxels[bin / LOBE_BINS].push_back(light);
        }
    }
    return voxels;
}

} // namespace eikonal::bake
