#include "common/given_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <tbb/parallel_for.h>

namespace eikonal {
namespace {

constexpr double kLeastStep = 1e-4;  // contrast per voxel below which the reflectance is under 1e-9
constexpr double kEndOfPiece = 0.02;
constexpr double kNarrowest = 0.5;  // voxels: even a step is wider to differences; narrower is noise beside kinks

/// Second-order differences [1 / voxel]: those of fourth order have lobes of the wrong sign beside a kink.
DenseGrid<glm::vec3> plainGradient(const DenseGrid<float>& ior) {
    DenseGrid<glm::vec3> gradient(ior.size, glm::vec3(0.0f));
    tbb::parallel_for(0, ior.size.z, [&](int k) {
        for (int j = 0; j < ior.size.y; ++j)
            for (int i = 0; i < ior.size.x; ++i)
                for (int axis = 0; axis < 3; ++axis) {
                    glm::ivec3 below(i, j, k), above(i, j, k);
                    below[axis] = std::max(below[axis] - 1, 0);
                    above[axis] = std::min(above[axis] + 1, ior.size[axis] - 1);
                    const int distance = std::max(above[axis] - below[axis], 1);
                    gradient.at(i, j, k)[axis] = (ior.at(above) - ior.at(below)) / float(distance);
                }
    });
    return gradient;
}

double indexAt(const DenseGrid<float>& ior, const glm::dvec3& position) {
    const glm::dvec3 p = glm::clamp(position, glm::dvec3(0.0), glm::dvec3(ior.size - 1));
    const glm::ivec3 low = glm::min(glm::ivec3(p), glm::max(ior.size - 2, glm::ivec3(0)));
    const glm::ivec3 high = glm::min(low + 1, ior.size - 1);
    const glm::dvec3 f = p - glm::dvec3(low);
    const auto row = [&](int j, int k) {
        return glm::mix(double(ior.at(low.x, j, k)), double(ior.at(high.x, j, k)), f.x);
    };
    const double below = glm::mix(row(low.y, low.z), row(high.y, low.z), f.y);
    const double above = glm::mix(row(low.y, high.z), row(high.y, high.z), f.y);
    return glm::mix(below, above, f.z);
}

/// One side of a monotone piece.
struct Walk {
    double index;     ///< n where the piece ends
    double steepest;  ///< largest change over one voxel on the way
    bool ended;       ///< false: still rising after `reach` voxels
    glm::dvec3 end;             ///< where it ends
    glm::dvec3 steepestPlace;   ///< where n changes fastest
};

/// From `start` along `direction`, in which n changes with `sign`.
Walk walk(const DenseGrid<float>& ior, const glm::dvec3& start, const glm::dvec3& direction, double sign,
          double steepest, int reach) {
    Walk result{indexAt(ior, start), steepest, false, start, start};
    for (int s = 1; s <= reach && !result.ended; ++s) {
        const glm::dvec3 position = start + double(s) * direction;
        const double next = indexAt(ior, position);
        const double change = sign * (next - result.index);
        result.ended = change < kEndOfPiece * result.steepest;
        if (!result.ended) {
            result.index = next;
            result.end = position;
            if (change > result.steepest) {
                result.steepest = change;
                result.steepestPlace = position - 0.5 * direction;
            }
        }
    }
    return result;
}

/// The monotone piece of n through a voxel, along its gradient [1 / voxel].
struct Piece {
    double low = 0.0, high = 0.0;  ///< n at its ends
    double widthVoxels = std::numeric_limits<double>::infinity();
};

/// Gradient across a direction, at the voxel nearest to a position.
double slopeAcross(const DenseGrid<glm::vec3>& gradient, const glm::dvec3& position, const glm::dvec3& direction) {
    const glm::ivec3 nearest = glm::clamp(glm::ivec3(glm::round(position)), glm::ivec3(0), gradient.size - 1);
    const glm::dvec3 g(gradient.at(nearest));
    return glm::length(g - glm::dot(g, direction) * direction);
}

Piece pieceThrough(const DenseGrid<float>& ior, const DenseGrid<glm::vec3>& gradient, const glm::ivec3& voxel,
                   int reach) {
    const glm::dvec3 own(gradient.at(voxel));
    const double slope = glm::length(own);
    const glm::dvec3 direction = own / slope;
    const Walk up = walk(ior, glm::dvec3(voxel), direction, 1.0, slope, reach);
    const Walk down = walk(ior, glm::dvec3(voxel), -direction, -1.0, slope, reach);
    Piece piece{down.index, up.index};
    const double steepest = std::max(up.steepest, down.steepest);
    // Across a boundary n changes along the walk only; otherwise the walk cuts obliquely through a gradient medium, as
    // gradients near its kinks let it.
    double across = 0.0;
    for (const glm::dvec3& place : {up.end, up.steepestPlace, down.end, down.steepestPlace})
        across = std::max(across, slopeAcross(gradient, place, direction));
    if (up.ended && down.ended && across < 0.5 * steepest)
        piece.widthVoxels = (up.index - down.index) / steepest;
    return piece;
}

/// Spreads the mask by two voxels along each axis in turn, into voxels where n still changes.
void includeTails(DenseGrid<unsigned char>& mask, const DenseGrid<glm::vec3>& gradient) {
    constexpr int kTailVoxels = 2;
    constexpr float kStillChanging = 1e-7f;
    DenseGrid<unsigned char> spread = mask;
    for (int axis = 0; axis < 3; ++axis) {
        const DenseGrid<unsigned char> source = spread;
        tbb::parallel_for(0, mask.size.z, [&](int k) {
            for (int j = 0; j < mask.size.y; ++j)
                for (int i = 0; i < mask.size.x; ++i)
                    for (int n = -kTailVoxels; n <= kTailVoxels; ++n) {
                        glm::ivec3 neighbour(i, j, k);
                        neighbour[axis] = std::clamp(neighbour[axis] + n, 0, mask.size[axis] - 1);
                        spread.at(i, j, k) |= source.at(neighbour);
                    }
        });
    }
    for (std::size_t v = 0; v < mask.values.size(); ++v)
        if (spread.values[v] && glm::length(gradient.values[v]) > kStillChanging)
            mask.values[v] = 255;
}

/// Share of the voxel's cube on the side of matter, were the boundary a plane halfway between the two sides.
float matterInBoundary(const Piece& piece, double index, double background) {
    const double contrast = piece.high - piece.low;
    const double towardsHigh = (index - 0.5 * (piece.low + piece.high)) / contrast;
    const double share = std::clamp(0.5 + towardsHigh * std::max(piece.widthVoxels, 1.0), 0.0, 1.0);
    constexpr double kAtBackground = 0.01;  // of the contrast: tails end early
    if (std::abs(piece.low - background) < kAtBackground * contrast)
        return float(share);
    return std::abs(piece.high - background) < kAtBackground * contrast ? float(1.0 - share) : 1.0f;
}

double largestContrast(const DenseGrid<float>& ior, double background) {
    double largest = 0.0;
    for (const float n : ior.values)
        largest = std::max(largest, std::abs(double(n) - background));
    return largest;
}

} // namespace

GivenIndex analyseGivenIndex(const DenseGrid<float>& ior, double smoothVoxels, double background) {
    constexpr double kLeastWidth = 1.5;
    const double widest = 1.5 * std::sqrt(2.0 * std::numbers::pi) * std::max(smoothVoxels, kLeastWidth);
    const int reach = int(std::ceil(1.5 * widest));
    const DenseGrid<glm::vec3> gradient = plainGradient(ior);
    const double matterContrast = 0.01 * largestContrast(ior, background);
    GivenIndex result{DenseGrid<unsigned char>(ior.size, 0), DenseGrid<float>(ior.size, 0.0f)};
    tbb::parallel_for(0, ior.size.z, [&](int k) {
        for (int j = 0; j < ior.size.y; ++j)
            for (int i = 0; i < ior.size.x; ++i) {
                const double n = ior.at(i, j, k);
                result.matter.at(i, j, k) = std::abs(n - background) > matterContrast ? 1.0f : 0.0f;
                if (!(glm::length(gradient.at(i, j, k)) > kLeastStep))
                    continue;
                const Piece piece = pieceThrough(ior, gradient, {i, j, k}, reach);
                const bool asBoundary = piece.widthVoxels > kNarrowest && piece.widthVoxels < widest;
                if (!asBoundary || piece.high - piece.low < kLeastStep)
                    continue;
                result.boundary.at(i, j, k) = 255;
                result.matter.at(i, j, k) = matterInBoundary(piece, n, background);
            }
    });
    includeTails(result.boundary, gradient);
    return result;
}

} // namespace eikonal
