#include "tools/lobe_grids.h"

#include <fmt/format.h>

#include "common/error.h"

namespace eikonal {

namespace {

std::string irradianceName(std::size_t lobe) { return fmt::format("lobe{}_irradiance", lobe + 1); }

std::string directionName(std::size_t lobe) { return fmt::format("lobe{}_direction", lobe + 1); }

const DenseGrid<glm::vec3>& lobeGrid(const VdbFile& file, const std::filesystem::path& path, const std::string& name,
                                     const glm::ivec3& size) {
    const VdbGrid& grid = vectorGrid(file, path, name);
    if (grid.size() != size) {
        throw badInput(fmt::format("{}: expected '{}' of the size of 'irradiance', found another", path.string(), name));
    }
    return grid.vector();
}

} // namespace

LobeGrids::LobeGrids(const BakedLight& light) {
    if (light.lobes.empty()) {
        return;
    }
    const DenseGrid<glm::vec3> dark(light.lattice.size, glm::vec3(0.0f));
    lobes_ = {{light.irradiance, light.lightDirection}, {dark, dark}, {dark, dark}};
    for (std::size_t row = 0; row < light.lobes.rows.size(); ++row) {
        const std::uint32_t voxel = light.lobes.voxels[row];
        for (std::size_t lobe = 0; lobe < kMostLobes; ++lobe) {
            lobes_[lobe].irradiance.values[voxel] = light.lobes.rows[row][lobe].irradiance;
            lobes_[lobe].direction.values[voxel] = light.lobes.rows[row][lobe].direction;
        }
    }
}

std::vector<NamedGrid> LobeGrids::named() const {
    std::vector<NamedGrid> grids;
    for (std::size_t lobe = 0; lobe < lobes_.size(); ++lobe) {
        grids.push_back({.name = irradianceName(lobe), .values = &lobes_[lobe].irradiance});
        grids.push_back({.name = directionName(lobe), .values = &lobes_[lobe].direction});
    }
    return grids;
}

LobeTable readLobes(const VdbFile& file, const std::filesystem::path& path, const glm::ivec3& size) {
    LobeTable table;
    if (file.find(irradianceName(0)) == nullptr) {
        return table;
    }
    std::array<const DenseGrid<glm::vec3>*, kMostLobes> irradiances{}, directions{};
    for (std::size_t lobe = 0; lobe < kMostLobes; ++lobe) {
        irradiances[lobe] = &lobeGrid(file, path, irradianceName(lobe), size);
        directions[lobe] = &lobeGrid(file, path, directionName(lobe), size);
    }
    for (std::size_t voxel = 0; voxel < irradiances[1]->values.size(); ++voxel) {
        if (overBands(irradiances[1]->values[voxel]) > 0.0) {
            table.voxels.push_back(std::uint32_t(voxel));
            VoxelLobes& row = table.rows.emplace_back();
            for (std::size_t lobe = 0; lobe < kMostLobes; ++lobe) {
                row[lobe] = {irradiances[lobe]->values[voxel], directions[lobe]->values[voxel]};
            }
        }
    }
    return table;
}

const VdbGrid& vectorGrid(const VdbFile& file, const std::filesystem::path& path, const std::string& name) {
    const VdbGrid* grid = file.find(name);
    if (grid == nullptr || grid->isScalar() || grid->vector().empty()) {
        const std::string found = grid == nullptr ? "none of that name" : "one of type " + grid->typeName;
        throw badInput(fmt::format("{}: expected a bake with a vector grid '{}', found {}", path.string(), name, found));
    }
    return *grid;
}

} // namespace eikonal
