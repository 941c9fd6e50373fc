#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/vdb_io.h"

namespace eikonal {

glm::ivec3 VdbGrid::size() const {
    return std::visit([](const auto& dense) { return dense.size; }, values);
}

glm::dvec3 VdbGrid::voxelSize() const {
    return {glm::length(glm::dvec3(worldFromIndex[0])), glm::length(glm::dvec3(worldFromIndex[1])),
            glm::length(glm::dvec3(worldFromIndex[2]))};
}

std::optional<std::string> VdbGrid::whatIsNotFinite() const {
    const auto isFinite = [](const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
    const auto find = [&](const auto& dense) -> std::optional<std::string> {
        const auto wrong = std::find_if_not(dense.values.begin(), dense.values.end(),
                                            [&](const auto& value) { return isFinite(glm::vec3(value)); });
        if (wrong == dense.values.end())
            return std::nullopt;
        const std::size_t v = std::size_t(wrong - dense.values.begin());
        const std::size_t nx = std::size_t(dense.size.x), ny = std::size_t(dense.size.y);
        const glm::dvec4 at = worldFromIndex * glm::dvec4(double(v % nx), double(v / nx % ny), double(v / (nx * ny)), 1.0);
        return fmt::format("expected finite values in grid '{}', found one that is not at ({:g}, {:g}, {:g})", name, at.x, at.y, at.z);
    };
    return std::visit(find, values);
}

const VdbGrid* VdbFile::find(const std::string& name) const {
    const auto found = std::find_if(grids.begin(), grids.end(), [&](const VdbGrid& grid) { return grid.name == name; });
    return found == grids.end() ? nullptr : &*found;
}

} // namespace eikonal
