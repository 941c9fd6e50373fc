#include <tbb/parallel_for.h>

#include "common/fields.h"

namespace eikonal {
namespace {

/// Derivative along a row of values, per voxel. Where four neighbours are missing the order falls to the second; at a
/// face it stays second, one-sided, so that linear and quadratic n keep their exact gradient up to the boundary.
double derivative(const float* row, std::ptrdiff_t stride, int i, int count) {
    const auto n = [&](int offset) { return double(row[stride * (i + offset)]); };
    if (count == 1)
        return 0.0;
    if (count == 2)
        return i == 0 ? n(1) - n(0) : n(0) - n(-1);
    if (i == 0)
        return 0.5 * (-3.0 * n(0) + 4.0 * n(1) - n(2));
    if (i == count - 1)
        return 0.5 * (3.0 * n(0) - 4.0 * n(-1) + n(-2));
    if (i == 1 || i == count - 2)
        return 0.5 * (n(1) - n(-1));
    return (8.0 * (n(1) - n(-1)) - (n(2) - n(-2))) / 12.0;
}

/// Linear interpolation of samples lies beyond a curved function: by h²/12 of each second derivative on the average over a
/// cell. Stored values that are less by that share give integrals along rays without the bias.
DenseGrid<glm::vec3> unbiasedForLinearInterpolation(const DenseGrid<glm::vec3>& grid) {
    DenseGrid<glm::vec3> unbiased = grid;
    const glm::ivec3 last = grid.size - 1;
    tbb::parallel_for(0, grid.size.z, [&](int k) {
        for (int j = 0; j < grid.size.y; ++j)
            for (int i = 0; i < grid.size.x; ++i) {
                const glm::ivec3 here(i, j, k);
                for (int axis = 0; axis < 3; ++axis) {
                    if (here[axis] == 0 || here[axis] == last[axis])
                        continue;
                    glm::ivec3 step(0);
                    step[axis] = 1;
                    unbiased.at(here) -=
                        (grid.at(here + step) - 2.0f * grid.at(here) + grid.at(here - step)) * (1.0f / 12.0f);
                }
            }
    });
    return unbiased;
}

} // namespace

DenseGrid<glm::vec3> gradientOf(const DenseGrid<float>& ior, double voxel) {
    DenseGrid<glm::vec3> gradient(ior.size, glm::vec3(0.0f));
    const std::ptrdiff_t rowStride = ior.size.x, slabStride = rowStride * ior.size.y;
    const float* values = ior.values.data();
    tbb::parallel_for(0, ior.size.z, [&](int k) {
        for (int j = 0; j < ior.size.y; ++j)
            for (int i = 0; i < ior.size.x; ++i) {
                const float* alongX = values + k * slabStride + j * rowStride;
                const float* alongY = values + k * slabStride + i;
                const float* alongZ = values + j * rowStride + i;
                gradient.at(i, j, k) = glm::vec3(glm::dvec3(derivative(alongX, 1, i, ior.size.x),
                                                            derivative(alongY, rowStride, j, ior.size.y),
                                                            derivative(alongZ, slabStride, k, ior.size.z)) / voxel);
            }
    });
    return unbiasedForLinearInterpolation(gradient);
}

} // namespace eikonal
