#include "common/distance_extension.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace eikonal {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// Solves sum over axes of max(u - a, 0)² = 1 (Zhao, Eq. 2.4): as many of the nearest neighbours count as lie below u.
float godunov(std::array<float, 3> a) {
    std::sort(a.begin(), a.end());
    if (a[0] == kFar)
        return kFar;
    float u = a[0] + 1.0f;
    if (u > a[1])
        u = 0.5f * (a[0] + a[1] + std::sqrt(std::max(0.0f, 2.0f - (a[0] - a[1]) * (a[0] - a[1]))));
    if (u > a[2]) {
        const float sum = a[0] + a[1] + a[2];
        const float squares = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
        u = (sum + std::sqrt(std::max(0.0f, sum * sum - 3.0f * (squares - 1.0f)))) / 3.0f;
    }
    return u;
}

float nearerNeighbour(const DenseGrid<float>& u, const glm::ivec3& v, int axis) {
    float nearest = kFar;
    for (const int step : {-1, 1}) {
        glm::ivec3 neighbour = v;
        neighbour[axis] += step;
        if (neighbour[axis] >= 0 && neighbour[axis] < u.size[axis])
            nearest = std::min(nearest, u.at(neighbour));
    }
    return nearest;
}

void sweep(DenseGrid<float>& u, const DenseGrid<unsigned char>& fixed, int directions) {
    const auto index = [&](int n, int axis) { return (directions >> axis) & 1 ? u.size[axis] - 1 - n : n; };
    for (int k = 0; k < u.size.z; ++k)
        for (int j = 0; j < u.size.y; ++j)
            for (int i = 0; i < u.size.x; ++i) {
                const glm::ivec3 v(index(i, 0), index(j, 1), index(k, 2));
                if (fixed.at(v))
                    continue;
                float& value = u.at(v);
                value = std::min(value, godunov({nearerNeighbour(u, v, 0), nearerNeighbour(u, v, 1),
                                                 nearerNeighbour(u, v, 2)}));
            }
}

} // namespace

void extendDistance(DenseGrid<float>& distanceVoxels, double known) {
    DenseGrid<float> magnitude(distanceVoxels.size, kFar);
    DenseGrid<unsigned char> fixed(distanceVoxels.size, 0);
    for (std::size_t v = 0; v < magnitude.values.size(); ++v) {
        const float distance = std::abs(distanceVoxels.values[v]);
        if (distance < known) {
            magnitude.values[v] = distance;
            fixed.values[v] = 1;
        }
    }
    for (int directions = 0; directions < 8; ++directions)
        sweep(magnitude, fixed, directions);
    for (std::size_t v = 0; v < magnitude.values.size(); ++v)
        distanceVoxels.values[v] = std::copysign(magnitude.values[v], distanceVoxels.values[v]);
}

} // namespace eikonal
