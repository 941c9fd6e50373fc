#include "tools/bench/cubic_field.h"

#include <array>

#include <tbb/parallel_for.h>

namespace eikonal::bench {

namespace {

const double kPole = std::sqrt(3.0) - 2.0;

/// Coefficients from samples along a row, in place: a causal and an anticausal recursion, mirrored at both ends.
void prefilterRow(float* row, std::ptrdiff_t stride, int count) {
    if (count < 2) {
        return;
    }
    const auto at = [&](int i) -> float& { return row[stride * i]; };
    double first = 0.0, power = 1.0;
    for (int i = 0; i < std::min(count, 40); ++i, power *= kPole) {  // beyond it the pole's powers are below rounding
        first += power * at(i);
    }
    double previous = first;
    at(0) = float(6.0 * first);
    for (int i = 1; i < count; ++i) {
        previous = double(at(i)) + kPole * previous;
        at(i) = float(6.0 * previous);
    }
    double next = kPole / (kPole * kPole - 1.0) * (double(at(count - 1)) + kPole * double(at(count - 2)));
    at(count - 1) = float(next);
    for (int i = count - 2; i >= 0; --i) {
        next = kPole * (next - double(at(i)));
        at(i) = float(next);
    }
}

void prefilter(DenseGrid<float>& grid) {
    const glm::ivec3 size = grid.size;
    const std::ptrdiff_t row = size.x, slab = row * size.y;
    float* values = grid.values.data();
    tbb::parallel_for(0, size.z, [&](int k) {
        for (int j = 0; j < size.y; ++j) prefilterRow(values + k * slab + j * row, 1, size.x);
        for (int i = 0; i < size.x; ++i) prefilterRow(values + k * slab + i, row, size.y);
    });
    tbb::parallel_for(0, size.y, [&](int j) {
        for (int i = 0; i < size.x; ++i) prefilterRow(values + j * row + i, slab, size.z);
    });
}

struct Weights {
    std::array<double, 4> value, slope;
};

/// Of the four coefficients about a place t in [0, 1) between the second and the third.
Weights weightsAt(double t) {
    const double u = 1.0 - t;
    return {{u * u * u / 6.0, (4.0 - 3.0 * t * t * (2.0 - t)) / 6.0, (4.0 - 3.0 * u * u * (2.0 - u)) / 6.0, t * t * t / 6.0},
            {-0.5 * u * u, -2.0 * t + 1.5 * t * t, 2.0 * u - 1.5 * u * u, 0.5 * t * t}};
}

int mirrored(int i, int count) {
    const int last = count - 1;
    const int inside = i < 0 ? -i : i > last ? 2 * last - i : i;
    return std::clamp(inside, 0, last);
}

} // namespace

CubicField::CubicField(const DenseGrid<float>& samples, const Lattice& lattice) : lattice_(lattice), coefficients_(samples) {
    prefilter(coefficients_);
}

reference::Optics CubicField::optics(const glm::dvec3& x) const {
    const glm::dvec3 place = (x - lattice_.min) / lattice_.voxel - 0.5;
    const glm::ivec3 lower(glm::floor(place));
    const glm::dvec3 t = place - glm::dvec3(lower);
    const Weights wx = weightsAt(t.x), wy = weightsAt(t.y), wz = weightsAt(t.z);
    glm::dvec4 sum(0.0);  // gradient by voxel, value
    for (std::size_t c = 0; c < 4; ++c) {
        const int k = mirrored(lower.z + int(c) - 1, lattice_.size.z);
        for (std::size_t b = 0; b < 4; ++b) {
            const int j = mirrored(lower.y + int(b) - 1, lattice_.size.y);
            double value = 0.0, slope = 0.0;
            for (std::size_t a = 0; a < 4; ++a) {
                const double coefficient = coefficients_.at(mirrored(lower.x + int(a) - 1, lattice_.size.x), j, k);
                value += wx.value[a] * coefficient;
                slope += wx.slope[a] * coefficient;
            }
            sum += glm::dvec4(slope * wy.value[b] * wz.value[c], value * wy.slope[b] * wz.value[c],
                              value * wy.value[b] * wz.slope[c], value * wy.value[b] * wz.value[c]);
        }
    }
    return {sum.w, glm::dvec3(sum) / lattice_.voxel};
}

} // namespace eikonal::bench
