#include "common/cubic_spline.h"

#include <algorithm>
#include <vector>

#include <tbb/parallel_for.h>

namespace eikonal {

namespace {

/// Solves c[i - 1] + 4 c[i] + c[i + 1] = 6 f[i] between two coefficients that are known (L. H. Thomas's elimination).
void solveBetween(int first, int last, const double* f, double* c) {
    std::vector<double> factor(std::size_t(last - first + 1), 0.0);
    for (int i = first + 1; i < last; ++i) {
        factor[std::size_t(i - first)] = 1.0 / (4.0 - factor[std::size_t(i - first - 1)]);
        c[i] = (6.0 * f[i] - c[i - 1]) * factor[std::size_t(i - first)];
    }
    for (int i = last - 1; i > first; --i) {
        c[i] -= factor[std::size_t(i - first)] * c[i + 1];
    }
}

/// `count` samples f to coefficients c[-1] to c[count].
void interpolateRow(int count, const double* f, double* c) {
    const int last = count - 1;
    const bool cubicEnds = count >= 4;
    if (cubicEnds) {
        c[1] = (8.0 * f[1] - f[0] - f[2]) / 6.0;
        c[last - 1] = (8.0 * f[last - 1] - f[last] - f[last - 2]) / 6.0;
        solveBetween(1, last - 1, f, c);
        c[0] = 6.0 * f[1] - 4.0 * c[1] - c[2];
        c[last] = 6.0 * f[last - 1] - 4.0 * c[last - 1] - c[last - 2];
    } else {
        c[0] = f[0];
        c[last] = f[last];
        solveBetween(0, last, f, c);
    }
    c[-1] = 6.0 * f[0] - 4.0 * c[0] - c[1];
    c[count] = 6.0 * f[last] - 4.0 * c[last] - c[last - 1];
}

/// Replaces the samples along an axis, which begin at 1, by coefficients.
void interpolateAlong(int axis, DenseGrid<float>& grid) {
    const int count = grid.size[axis] - 2;
    const int across = (axis + 1) % 3, along = (axis + 2) % 3;
    tbb::parallel_for(0, grid.size[across], [&](int a) {
        std::vector<double> f(static_cast<std::size_t>(count)), c(std::size_t(count) + 2);
        glm::ivec3 at(0);
        at[across] = a;
        for (at[along] = 0; at[along] < grid.size[along]; ++at[along]) {
            for (at[axis] = 1; at[axis] <= count; ++at[axis]) f[std::size_t(at[axis] - 1)] = double(grid.at(at));
            interpolateRow(count, f.data(), c.data() + 1);
            for (at[axis] = 0; at[axis] < count + 2; ++at[axis]) grid.at(at) = float(c[std::size_t(at[axis])]);
        }
    });
}

} // namespace

DenseGrid<float> splineCoefficients(const DenseGrid<float>& samples) {
    const glm::ivec3 size = glm::max(samples.size, glm::ivec3(2));
    DenseGrid<float> grid(size + 2, 0.0f);
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                grid.at(i + 1, j + 1, k + 1) = samples.at(glm::min(glm::ivec3(i, j, k), samples.size - 1));
            }
        }
    }
    for (int axis = 0; axis < 3; ++axis) interpolateAlong(axis, grid);
    return grid;
}

SplinePlace splinePlace(const Lattice& lattice, const glm::dvec3& x) {
    const glm::dvec3 last(lattice.size - 1);
    const glm::dvec3 place = glm::clamp((x - lattice.min) / lattice.voxel - 0.5, glm::dvec3(0.0), last);
    const glm::dvec3 lower = glm::min(glm::floor(place), glm::max(last - 1.0, glm::dvec3(0.0)));
    return {glm::ivec3(lower), place - lower};
}

} // namespace eikonal
