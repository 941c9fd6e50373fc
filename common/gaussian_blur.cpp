#include "common/gaussian_blur.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace eikonal {
namespace {

/// Weights at 0, 1, 2, ... voxels, summing to 1 over both sides.
std::vector<double> halfKernel(double sigmaVoxels) {
    std::vector<double> weights(std::size_t(std::ceil(4.0 * sigmaVoxels)) + 1);
    double sum = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        weights[i] = std::exp(-0.5 * double(i * i) / (sigmaVoxels * sigmaVoxels));
        sum += i == 0 ? weights[i] : 2.0 * weights[i];
    }
    for (double& weight : weights)
        weight /= sum;
    return weights;
}

DenseGrid<glm::vec3> blurAxis(const DenseGrid<glm::vec3>& grid, const std::vector<double>& weights, int axis) {
    DenseGrid<glm::vec3> result(grid.size, glm::vec3(0.0f));
    tbb::parallel_for(0, grid.size.z, [&](int k) {
        for (int j = 0; j < grid.size.y; ++j)
            for (int i = 0; i < grid.size.x; ++i) {
                const glm::ivec3 centre(i, j, k);
                glm::dvec3 sum = weights[0] * glm::dvec3(grid.at(centre));
                for (int n = 1; n < int(weights.size()); ++n) {
                    glm::ivec3 below = centre, above = centre;
                    below[axis] = std::max(centre[axis] - n, 0);
                    above[axis] = std::min(centre[axis] + n, grid.size[axis] - 1);
                    sum += weights[std::size_t(n)] * (glm::dvec3(grid.at(below)) + glm::dvec3(grid.at(above)));
                }
                result.at(centre) = glm::vec3(sum);
            }
    });
    return result;
}

} // namespace

DenseGrid<glm::vec3> gaussianBlur(const DenseGrid<glm::vec3>& grid, double sigmaVoxels) {
    if (!(sigmaVoxels > 0.0))
        return grid;
    const std::vector<double> weights = halfKernel(sigmaVoxels);
    return blurAxis(blurAxis(blurAxis(grid, weights, 0), weights, 1), weights, 2);
}

} // namespace eikonal
