#include "lightsim/tubes/detail.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "common/depth.h"
#include "common/field_pyramid.h"

namespace eikonal::bake {

namespace {

// A glass of index 1.5 turns rays at its boundary, three voxels wide, by up to 0.2 a voxel; one of 1.02 by 0.01.
constexpr float kTurn = 0.01f;      // [rad per voxel of path]: second difference, from one voxel to the next
constexpr float kDepth = 0.02f;     // optical depth per voxel of path
constexpr double kCoverage = 0.05;  // of a voxel by opaque matter

double freeShare(const Fields& fields, const glm::ivec3& voxel) {
    return freeShareAt(fields.opaque, fields.opaque.offset(voxel.x, voxel.y, voxel.z));
}

/// Whether anything changes along an axis, in voxel `at` and the neighbours `low` and `high` of it.
bool changesAlong(const Fields& fields, const glm::ivec3& low, const glm::ivec3& at, const glm::ivec3& high) {
    const float voxel = float(fields.lattice.voxel);
    const auto changes = [&](const DenseGrid<glm::vec3>& sigma) {
        const glm::vec3 change = sigma.empty() ? glm::vec3(0.0f) : glm::abs(sigma.at(high) - sigma.at(at)) * voxel;
        return std::max({change.x, change.y, change.z}) > kDepth;
    };
    if (!fields.iorGradient.empty()) {
        const glm::vec3 second =
            fields.iorGradient.at(low) - 2.0f * fields.iorGradient.at(at) + fields.iorGradient.at(high);
        if (glm::length(second) * voxel > kTurn * fields.ior.at(at)) {
            return true;
        }
    }
    return changes(fields.sigmaA) || changes(fields.sigmaS) ||
           std::abs(freeShare(fields, high) - freeShare(fields, at)) > kCoverage;
}

bool isDetailed(const Fields& fields, const glm::ivec3& voxel) {
    for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 low = voxel, high = voxel;
        low[axis] = std::max(voxel[axis] - 1, 0);
        high[axis] = std::min(voxel[axis] + 1, fields.lattice.size[axis] - 1);
        if (changesAlong(fields, low, voxel, high)) {
            return true;
        }
    }
    return false;
}

bool anyDetailed(const Fields& fields, const glm::ivec3& first, const glm::ivec3& end) {
    for (int k = first.z; k < end.z; ++k)
        for (int j = first.y; j < end.y; ++j)
            for (int i = first.x; i < end.x; ++i)
                if (isDetailed(fields, {i, j, k})) return true;
    return false;
}

} // namespace

DenseGrid<unsigned char> distanceToDetail(const Fields& fields) {
    DenseGrid<unsigned char> distance((fields.lattice.size + kBrickVoxels - 1) / kBrickVoxels, 255);
    tbb::parallel_for(0, distance.size.z, [&](int k) {
        for (int j = 0; j < distance.size.y; ++j)
            for (int i = 0; i < distance.size.x; ++i) {
                const glm::ivec3 first = glm::ivec3(i, j, k) * kBrickVoxels;
                if (anyDetailed(fields, first, glm::min(first + kBrickVoxels, fields.lattice.size))) {
                    distance.at(i, j, k) = 0;
                }
            }
    });
    spreadDistances(distance);
    return distance;
}

gpu::Texture3D detailTexture(const gpu::Context& context, const DenseGrid<unsigned char>& distance) {
    gpu::Texture3D texture(context, gpu::TexelFormat::kR8, distance.size, "detail");
    texture.upload(distance.values.data());
    return texture;
}

bool isAnywhere(const DenseGrid<unsigned char>& distanceToDetail) {
    const auto& bricks = distanceToDetail.values;
    return std::any_of(bricks.begin(), bricks.end(), [](unsigned char distance) { return distance < 255; });
}

} // namespace eikonal::bake
