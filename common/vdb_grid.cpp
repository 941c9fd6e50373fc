#include <algorithm>

#include "common/vdb_io.h"

namespace eikonal {

glm::ivec3 VdbGrid::size() const {
    return std::visit([](const auto& dense) { return dense.size; }, values);
}

glm::dvec3 VdbGrid::voxelSize() const {
    return {glm::length(glm::dvec3(worldFromIndex[0])), glm::length(glm::dvec3(worldFromIndex[1])),
            glm::length(glm::dvec3(worldFromIndex[2]))};
}

const VdbGrid* VdbFile::find(const std::string& name) const {
    const auto found = std::find_if(grids.begin(), grids.end(), [&](const VdbGrid& grid) { return grid.name == name; });
    return found == grids.end() ? nullptr : &*found;
}

} // namespace eikonal
