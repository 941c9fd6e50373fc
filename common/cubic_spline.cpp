#include "common/cubic_spline.h"

#include <algorithm>
#include <functional>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

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

/// Squares of second and of fourth differences.
struct Squares {
    double second = 0.0, fourth = 0.0;

    Squares operator+(const Squares& other) const { return {second + other.second, fourth + other.fourth}; }
};

/// Of a voxel along all axes that have two neighbours on either side.
Squares squaresAt(const DenseGrid<float>& samples, const glm::ivec3& voxel) {
    Squares sum;
    for (int axis = 0; axis < 3; ++axis) {
        if (voxel[axis] < 2 || voxel[axis] >= samples.size[axis] - 2) continue;
        const auto at = [&](int offset) {
            glm::ivec3 neighbour = voxel;
            neighbour[axis] += offset;
            return double(samples.at(neighbour));
        };
        const double second = at(-1) - 2.0 * at(0) + at(1);
        const double fourth = at(-2) - 4.0 * (at(-1) + at(1)) + 6.0 * at(0) + at(2);
        sum = sum + Squares{second * second, fourth * fourth};
    }
    return sum;
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

double kinkShare(const DenseGrid<float>& samples) {
    const auto ofLayers = [&](const tbb::blocked_range<int>& layers, Squares sum) {
        for (int k = layers.begin(); k != layers.end(); ++k)
            for (int j = 0; j < samples.size.y; ++j)
                for (int i = 0; i < samples.size.x; ++i) sum = sum + squaresAt(samples, {i, j, k});
        return sum;
    };
    const Squares sum =
        tbb::parallel_deterministic_reduce(tbb::blocked_range<int>(0, samples.size.z), Squares{}, ofLayers, std::plus<>());
    // A kink t of the way from one voxel to the next has second differences 1 - t and t, from 0 and to 0: fourth ones have
    // 6 (1 - t)² + 6 t² - 8 t (1 - t) of squares.
    constexpr double kOfKinks = 4.0;
    return sum.second > 0.0 ? sum.fourth / (kOfKinks * sum.second) : 0.0;
}

SplinePlace splinePlace(const Lattice& lattice, const glm::dvec3& x) {
    const glm::dvec3 last(lattice.size - 1);
    const glm::dvec3 place = glm::clamp((x - lattice.min) / lattice.voxel - 0.5, glm::dvec3(0.0), last);
    const glm::dvec3 lower = glm::min(glm::floor(place), glm::max(last - 1.0, glm::dvec3(0.0)));
    return {glm::ivec3(lower), place - lower};
}

} // namespace eikonal
