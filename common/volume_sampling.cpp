#include "common/volume_sampling.h"

#include <cmath>

#include <tbb/parallel_for.h>

namespace eikonal {
namespace {

constexpr double kEdgeSlack = 1e-6;  // voxels; rounding of transforms

bool inBox(const glm::dvec3& p, const glm::ivec3& size) {
    const glm::dvec3 high = glm::dvec3(size) - 0.5 + kEdgeSlack;
    return glm::all(glm::greaterThanEqual(p, glm::dvec3(-0.5 - kEdgeSlack))) && glm::all(glm::lessThanEqual(p, high));
}

/// Weights are built so that a position on a centre takes that voxel's value to the bit.
template <class Value>
glm::dvec3 trilinear(const DenseGrid<Value>& grid, const glm::dvec3& position) {
    const glm::dvec3 last(grid.size - 1);
    const glm::dvec3 p = glm::clamp(position, glm::dvec3(0.0), last);
    const glm::ivec3 low = glm::min(glm::ivec3(glm::floor(p)), glm::max(grid.size - 2, glm::ivec3(0)));
    const glm::dvec3 f = p - glm::dvec3(low);
    glm::dvec3 sum(0.0);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::dvec3 weights = glm::mix(1.0 - f, f, glm::dvec3(side));
        const double weight = weights.x * weights.y * weights.z;
        if (weight > 0.0)
            sum += weight * glm::dvec3(grid.at(glm::min(low + side, grid.size - 1)));
    }
    return sum;
}

template <class Function>
void forEachVoxel(const Lattice& lattice, const PlacedGrid& placed, const Function& function) {
    tbb::parallel_for(0, lattice.size.z, [&](int k) {
        for (int j = 0; j < lattice.size.y; ++j)
            for (int i = 0; i < lattice.size.x; ++i)
                function(i, j, k, glm::dvec3(placed.gridFromDomainIndex * glm::dvec4(i, j, k, 1.0)));
    });
}

} // namespace

PlacedGrid::PlacedGrid(const VdbGrid& source, const glm::dmat4& worldFromLocal, const Lattice& lattice)
    : grid(&source) {
    glm::dmat4 worldFromDomainIndex(lattice.voxel);
    worldFromDomainIndex[3] = glm::dvec4(lattice.worldFromIndex({0, 0, 0}), 1.0);
    gridFromDomainIndex = glm::inverse(worldFromLocal * source.worldFromIndex) * worldFromDomainIndex;
    constexpr double kCoincident = 1e-4;  // voxels over the whole grid; files hold float transforms
    const double length = double(std::max({lattice.size.x, lattice.size.y, lattice.size.z}));
    glm::dmat4 snapped(1.0);
    bool coincide = true;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) {
            snapped[column][row] = std::round(gridFromDomainIndex[column][row]);
            const double error = std::abs(gridFromDomainIndex[column][row] - snapped[column][row]);
            coincide = coincide && (column == 3 ? error : error * length) < kCoincident;
        }
    if (coincide)
        gridFromDomainIndex = snapped;
}

DenseGrid<glm::vec3> resample(const PlacedGrid& placed, const Lattice& lattice) {
    DenseGrid<glm::vec3> result(lattice.size, glm::vec3(0.0f));
    const glm::vec3 outside = placed.grid->isScalar() ? glm::vec3(placed.grid->background.x) : placed.grid->background;
    forEachVoxel(lattice, placed, [&](int i, int j, int k, const glm::dvec3& p) {
        if (!inBox(p, placed.grid->size()))
            result.at(i, j, k) = outside;
        else
            result.at(i, j, k) = std::visit([&](const auto& values) { return glm::vec3(trilinear(values, p)); },
                                            placed.grid->values);
    });
    return result;
}

DenseGrid<float> firstComponent(const DenseGrid<glm::vec3>& grid) {
    DenseGrid<float> result(grid.size, 0.0f);
    std::transform(grid.values.begin(), grid.values.end(), result.values.begin(), [](const glm::vec3& v) { return v.x; });
    return result;
}

DenseGrid<float> boxCoverage(const PlacedGrid& placed, const Lattice& lattice) {
    DenseGrid<float> result(lattice.size, 0.0f);
    forEachVoxel(lattice, placed, [&](int i, int j, int k, const glm::dvec3& p) {
        result.at(i, j, k) = inBox(p, placed.grid->size()) ? 1.0f : 0.0f;
    });
    return result;
}

} // namespace eikonal
