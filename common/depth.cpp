#include "common/depth.h"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "common/physics.h"

namespace eikonal {
namespace {

/// value(voxel, offset) at every voxel.
template <class ValueAt>
DenseGrid<float> gridOf(const glm::ivec3& size, const ValueAt& valueAt) {
    DenseGrid<float> grid(size, 0.0f);
    tbb::parallel_for(0, size.z, [&](int k) {
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i)
                grid.at(i, j, k) = valueAt(glm::ivec3(i, j, k), grid.offset(i, j, k));
    });
    return grid;
}

DenseGrid<float> inverse(const DenseGrid<float>& depth) {
    return gridOf(depth.size, [&](const glm::ivec3&, std::size_t v) { return 1.0f - depth.values[v]; });
}

/// The least or greatest value, by `chosen`, of those within `reach` along each axis.
template <class Chosen>
DenseGrid<float> spread(DenseGrid<float> grid, int reach, const Chosen& chosen) {
    for (int axis = 0; axis < 3; ++axis)
        grid = gridOf(grid.size, [&](glm::ivec3 voxel, std::size_t) {
            const int middle = voxel[axis], end = std::min(middle + reach, grid.size[axis] - 1);
            voxel[axis] = std::max(middle - reach, 0);
            float found = grid.at(voxel);
            while (++voxel[axis] <= end)
                found = chosen(found, grid.at(voxel));
            return found;
        });
    return grid;
}

glm::vec3 differencesAt(const DenseGrid<float>& grid, const glm::ivec3& voxel) {
    glm::vec3 differences(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 low = voxel, high = voxel;
        low[axis] = std::max(voxel[axis] - 1, 0);
        high[axis] = std::min(voxel[axis] + 1, grid.size[axis] - 1);
        differences[axis] = grid.at(high) - grid.at(low);
    }
    return differences;
}

/// Between the gradients; 1 where there is none.
float cosineAt(const DenseGrid<float>& a, const DenseGrid<float>& b, const glm::ivec3& voxel) {
    const glm::vec3 ofA = differencesAt(a, voxel), ofB = differencesAt(b, voxel);
    const float lengths = glm::length(ofA) * glm::length(ofB);
    return lengths > 0.0f ? glm::dot(ofA, ofB) / lengths : 1.0f;
}

} // namespace

double depthFromDistance(double distanceVoxels) {
    return std::clamp(0.5 - distanceVoxels, double(gpu::kLeastDepth), double(gpu::kMostDepth));
}

DenseGrid<float> depthFromShares(const DenseGrid<float>& shares) {
    constexpr int kSeen = 3;  // voxels from one that is more than half full to the farthest that a normal of its surface sees
    const DenseGrid<float> most = spread(shares, kSeen, [](float a, float b) { return std::max(a, b); });
    const DenseGrid<float> least = spread(shares, kSeen, [](float a, float b) { return std::min(a, b); });
    return gridOf(shares.size, [&](const glm::ivec3&, std::size_t v) {
        return most.values[v] <= 0.0f ? gpu::kLeastDepth : least.values[v] >= 1.0f ? gpu::kMostDepth : shares.values[v];
    });
}

DenseGrid<float> sharesOf(DenseGrid<float> depth) {
    for (float& value : depth.values)
        value = f32::shareOfDepth(value);
    return depth;
}

double freeShareAt(const DenseGrid<float>& opaqueDepth, std::size_t offset) {
    return opaqueDepth.empty() ? 1.0 : 1.0 - f64::shareOfDepth(double(opaqueDepth.values[offset]));
}

DenseGrid<float> joined(const DenseGrid<float>& a, const DenseGrid<float>& b) {
    return gridOf(a.size, [&](const glm::ivec3& voxel, std::size_t v) {
        const bool bothCut = std::min(a.values[v], b.values[v]) > 0.0f;
        return f32::joinedDepth(a.values[v], b.values[v], bothCut ? cosineAt(a, b, voxel) : 1.0f);
    });
}

DenseGrid<float> overlap(const DenseGrid<float>& a, const DenseGrid<float>& b) {
    return gridOf(a.size, [&](const glm::ivec3&, std::size_t v) { return std::min(a.values[v], b.values[v]); });
}

DenseGrid<float> without(const DenseGrid<float>& a, const DenseGrid<float>& b) { return inverse(joined(inverse(a), b)); }

} // namespace eikonal
