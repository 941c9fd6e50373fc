#include "lightsim/tubes/eikonal_deposit.h"

#include <bit>

#include "common/baked_light.h"

namespace eikonal::bake {

EikonalDeposit::EikonalDeposit(const gpu::Context& context, const std::vector<std::string>& defines, const Lattice& lattice,
                               int layers)
    : voxelsPerLayer_(std::size_t(lattice.size.x) * std::size_t(lattice.size.y)),
      leastPaths_(context, voxelsPerLayer_ * std::size_t(layers) * sizeof(std::uint32_t), "eikonal") {
    for (int list = 0; list < TUBE_DEPOSIT_LISTS; ++list) {
        std::vector<std::string> variant = defines;
        variant.push_back("PART_LIST " + std::to_string(list));
        kernels_.emplace_back(context, "lightsim/tubes/eikonal.comp.glsl", variant);
    }
}

void EikonalDeposit::add(const gpu::Buffer& parts) const {
    leastPaths_.bindStorage(TUBE_EIKONAL_BINDING);
    for (std::size_t list = 0; list < kernels_.size(); ++list) {
        kernels_[list].dispatchIndirect(parts, list * sizeof(TubePartList) + offsetof(TubePartList, groups));
    }
}

void EikonalDeposit::read(const BakeSettings& settings, DenseGrid<float>& grid) const {
    const auto words = leastPaths_.download<std::uint32_t>(voxelsPerLayer_ * std::size_t(settings.slabEnd - settings.slabBegin));
    const std::size_t first = voxelsPerLayer_ * std::size_t(settings.slabBegin);
    for (std::size_t i = 0; i < words.size(); ++i) {
        grid.values[first + i] = words[i] == kNoPath ? kUnreached : std::bit_cast<float>(words[i]);
    }
}

} // namespace eikonal::bake
