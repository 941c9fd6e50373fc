#include "common/field_pyramid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <tbb/parallel_for.h>

#include "common/physics.h"
#include "common/spectral_fields.h"

namespace eikonal {
namespace {

/// Voxels from `first` to `last`, both included.
struct VoxelRange {
    glm::ivec3 first, last;

    template <class Visit>
    void forEach(const Visit& visit) const {
        for (int k = first.z; k <= last.z; ++k)
            for (int j = first.y; j <= last.y; ++j)
                for (int i = first.x; i <= last.x; ++i) visit(glm::ivec3(i, j, k));
    }
};

VoxelRange reachOf(const glm::ivec3& brick, const glm::ivec3& latticeSize) {
    const glm::ivec3 begin = brick * kBrickVoxels;
    return {glm::max(begin - 1, glm::ivec3(0)), glm::min(begin + kBrickVoxels, latticeSize - 1)};
}

void boundIndex(const Fields& fields, const VoxelRange& reach, FieldBrick& brick) {
    if (fields.iorGradient.empty()) {
        brick.iorMin = brick.iorMax = fields.iorUniform;
        return;
    }
    float squareMax = 0.0f;
    brick.iorMin = brick.iorMax = fields.ior.at(reach.first);
    reach.forEach([&](const glm::ivec3& voxel) {
        brick.iorMin = std::min(brick.iorMin, fields.ior.at(voxel));
        brick.iorMax = std::max(brick.iorMax, fields.ior.at(voxel));
        const glm::vec3& gradient = fields.iorGradient.at(voxel);
        squareMax = std::max(squareMax, glm::dot(gradient, gradient));
    });
    brick.gradientMax = std::sqrt(squareMax);
}

template <class Value, class Holds>
bool anyIn(const DenseGrid<Value>& grid, const VoxelRange& reach, const Holds& holds) {
    bool any = false;
    if (!grid.empty()) reach.forEach([&](const glm::ivec3& voxel) { any = any || holds(grid.at(voxel)); });
    return any;
}

void boundDispersion(const Fields& fields, const VoxelRange& reach, FieldBrick& brick) {
    if (fields.cauchyB.empty()) {
        return;
    }
    float cauchyMax = 0.0f, squareMax = 0.0f;
    reach.forEach([&](const glm::ivec3& voxel) {
        cauchyMax = std::max(cauchyMax, std::abs(fields.cauchyB.at(voxel)));
        const glm::vec3& gradient = fields.cauchyGradient.at(voxel);
        squareMax = std::max(squareMax, glm::dot(gradient, gradient));
    });
    const float term = float(f64::dispersionTerm(kShortestVisibleMicrons));  // greater than that of the other end
    brick.dispersionMax = term * cauchyMax;
    brick.dispersedGradientMax = term * std::sqrt(squareMax);
}

template <class Value>
bool isEven(const DenseGrid<Value>& grid, const VoxelRange& reach) {
    return !anyIn(grid, reach, [&](const Value& value) { return value != grid.at(reach.first); });
}

void boundMatter(const Fields& fields, const VoxelRange& reach, FieldBrick& brick) {
    const auto something = [](const glm::vec3& value) { return value != glm::vec3(0.0f); };
    brick.scatters = anyIn(fields.sigmaS, reach, something);
    brick.matter =
        brick.scatters || anyIn(fields.sigmaA, reach, something) || anyIn(fields.emission, reach, something);
    brick.evenMatter = !brick.matter || (isEven(fields.sigmaA, reach) && isEven(fields.sigmaS, reach) &&
                                         isEven(fields.emission, reach) &&
                                         (!brick.scatters || (isEven(fields.anisotropy, reach) &&
                                                              isEven(fields.anisotropyByBand, reach))));
    brick.opaque = anyIn(fields.opaque, reach, [](float coverage) { return coverage > 0.0f; });
}

/// Along one axis: max(|i - j|, distance at j), the least over all j. Done along x, y and z it is Chebyshev's distance.
void spreadAlong(int axis, DenseGrid<unsigned char>& distance) {
    const int count = distance.size[axis];
    const int across = (axis + 1) % 3, along = (axis + 2) % 3;
    tbb::parallel_for(0, distance.size[across], [&](int a) {
        std::vector<int> line(std::size_t(count), 0);
        for (int b = 0; b < distance.size[along]; ++b) {
            const auto at = [&](int i) -> unsigned char& {
                glm::ivec3 brick(0);
                brick[axis] = i;
                brick[across] = a;
                brick[along] = b;
                return distance.at(brick);
            };
            for (int i = 0; i < count; ++i) line[std::size_t(i)] = at(i);
            for (int i = 0; i < count; ++i) {
                int nearest = line[std::size_t(i)];
                for (int r = 1; r < nearest && (i - r >= 0 || i + r < count); ++r) {
                    if (i - r >= 0) nearest = std::min(nearest, std::max(r, line[std::size_t(i - r)]));
                    if (i + r < count) nearest = std::min(nearest, std::max(r, line[std::size_t(i + r)]));
                }
                at(i) = static_cast<unsigned char>(nearest);
            }
        }
    });
}

} // namespace

FieldPyramid fieldPyramidOf(const Fields& fields) {
    FieldPyramid pyramid;
    pyramid.lattice = fields.lattice;
    pyramid.bricks = DenseGrid<FieldBrick>((fields.lattice.size + kBrickVoxels - 1) / kBrickVoxels, FieldBrick{});
    const glm::ivec3 size = pyramid.bricks.size;
    tbb::parallel_for(0, size.z, [&](int k) {
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                FieldBrick& brick = pyramid.bricks.at(i, j, k);
                const VoxelRange reach = reachOf({i, j, k}, fields.lattice.size);
                boundIndex(fields, reach, brick);
                boundDispersion(fields, reach, brick);
                boundMatter(fields, reach, brick);
                brick.boundary = anyIn(fields.interface, reach, [](unsigned char marked) { return marked != 0; });
            }
    });
    return pyramid;
}

void boundArea(const DenseGrid<float>& area, FieldPyramid& pyramid) {
    const glm::ivec3 size = pyramid.bricks.size;
    tbb::parallel_for(0, size.z, [&](int k) {
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                FieldBrick& brick = pyramid.bricks.at(i, j, k);
                const VoxelRange reach = reachOf({i, j, k}, area.size);
                brick.matter = brick.matter || anyIn(area, reach, [](float share) { return share > 0.0f; });
                brick.evenMatter = brick.evenMatter && isEven(area, reach);
            }
    });
}

double negligibleGradient(const FieldPyramid& pyramid, double tolerance) {
    double low = std::numeric_limits<double>::infinity(), high = 0.0;
    for (const FieldBrick& brick : pyramid.bricks.values) {
        low = std::min(low, double(brick.iorMin));
        high = std::max(high, double(brick.iorMax));
    }
    const double voxel = pyramid.lattice.voxel;
    const glm::dvec3 extent = pyramid.lattice.extent();
    const double straightEnough = 2.0 * low * tolerance * voxel / glm::dot(extent, extent);
    // Neighbours half a unit in the last place off, each to its side: fourth-order differences of them, less their share
    // for interpolation, are one such unit along each axis.
    const double rounding = std::sqrt(3.0) * high * std::numeric_limits<float>::epsilon() / voxel;
    return std::max(straightEnough, rounding);
}

DenseGrid<unsigned char> clearanceOf(const FieldPyramid& pyramid,
                                     const std::function<bool(const FieldBrick&)>& isObstacle) {
    DenseGrid<unsigned char> distance(pyramid.bricks.size, 255);
    for (std::size_t b = 0; b < distance.values.size(); ++b)
        if (isObstacle(pyramid.bricks.values[b])) distance.values[b] = 0;
    spreadDistances(distance);
    return distance;
}

void spreadDistances(DenseGrid<unsigned char>& distance) {
    for (int axis = 0; axis < 3; ++axis) spreadAlong(axis, distance);
}

} // namespace eikonal
