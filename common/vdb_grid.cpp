#include <algorithm>
#include <cmath>

#include "common/vdb_io.h"

namespace eikonal {

glm::ivec3 VdbGrid::size() const {
    return std::visit([](const auto& dense) { return dense.size; }, values);
}

glm::dvec3 VdbGrid::voxelSize() const {
    return {glm::length(glm::dvec3(worldFromIndex[0])), glm::length(glm::dvec3(worldFromIndex[1])),
            glm::length(glm::dvec3(worldFromIndex[2]))};
}

std::optional<glm::dvec3> VdbGrid::placeThatIsNotFinite() const {
    const auto isFinite = [](const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
    const auto find = [&](const auto& dense) -> std::optional<glm::dvec3> {
        const auto wrong = std::find_if_not(dense.values.begin(), dense.values.end(), [&](const auto& v) { return isFinite(glm::vec3(v)); });
        if (wrong == dense.values.end())
            return std::nullopt;
        const std::size_t v = std::size_t(wrong - dense.values.begin()), nx = std::size_t(dense.size.x), ny = std::size_t(dense.size.y);
        return glm::dvec3(worldFromIndex * glm::dvec4(double(v % nx), double(v / nx % ny), double(v / (nx * ny)), 1.0));
    };
    return std::visit(find, values);
}

const VdbGrid* VdbFile::find(const std::string& name) const {
    const auto found = std::find_if(grids.begin(), grids.end(), [&](const VdbGrid& grid) { return grid.name == name; });
    return found == grids.end() ? nullptr : &*found;
}

} // namespace eikonal
