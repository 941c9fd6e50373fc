// The cubic B-spline through samples: it meets them, is exact for cubics up to the faces, and has its order elsewhere.
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "common/cubic_spline.h"
#include "common/reference/reference_field.h"

namespace eikonal {
namespace {

Fields samplesOf(const glm::ivec3& size, double voxel, const std::function<double(const glm::dvec3&)>& n) {
    Fields fields;
    fields.lattice = {glm::dvec3(-0.5 * voxel * size.x, 0.3, -1.0), voxel, size};
    fields.ior = DenseGrid<float>(size, 0.0f);
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) fields.ior.at(i, j, k) = float(n(fields.lattice.worldFromIndex({i, j, k})));
    fields.iorGradient = gradientOf(fields.ior, voxel);
    return fields;
}

/// A place within the box of the voxels' centres, by three shares of it.
glm::dvec3 within(const Lattice& lattice, const glm::dvec3& share) {
    return glm::mix(lattice.worldFromIndex(glm::ivec3(0)), lattice.worldFromIndex(lattice.size - 1), share);
}

TEST(CubicSpline, MeetsItsSamplesWhateverTheirNumber) {
    for (const glm::ivec3& size : {glm::ivec3(1), glm::ivec3(2, 3, 4), glm::ivec3(5, 1, 7), glm::ivec3(6)}) {
        const Fields fields =
            samplesOf(size, 0.25, [](const glm::dvec3& x) { return 1.5 + 0.3 * std::sin(5.0 * x.x + 3.0 * x.y - 4.0 * x.z); });
        const reference::GridField field(fields, Interpolation::kCubic);
        for (int v = 0; v < size.x * size.y * size.z; ++v) {
            const glm::ivec3 voxel(v % size.x, v / size.x % size.y, v / (size.x * size.y));
            // coefficients are floats of about 1.5, of which eight or so weigh much
            EXPECT_NEAR(field.optics(fields.lattice.worldFromIndex(voxel)).n, fields.ior.at(voxel), 1e-6);
        }
    }
}

TEST(CubicSpline, IsExactForCubicsUpToTheFaces) {
    const auto n = [](const glm::dvec3& x) { return 1.5 + x.x * x.x * x.x - 0.5 * x.y * x.y * x.z + 0.2 * x.z * x.z * x.z; };
    const Fields fields = samplesOf({9, 8, 7}, 0.125, n);
    const reference::GridField field(fields, Interpolation::kCubic);
    for (const glm::dvec3& share : {glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(0.03, 0.97, 0.5), glm::dvec3(0.5, 0.41, 1.0)}) {
        const glm::dvec3 x = within(fields.lattice, share);
        const reference::Optics found = field.optics(x);
        const glm::dvec3 gradient(3.0 * x.x * x.x, -x.y * x.z, -0.5 * x.y * x.y + 0.6 * x.z * x.z);
        EXPECT_NEAR(found.n, n(x), 2e-6);                              // floats
        EXPECT_LT(glm::length(found.gradN - gradient), 2e-6 / 0.125);  // and their differences over a voxel
    }
}

/// Largest errors of n and of its gradient at 1000 places up to the faces.
glm::dvec2 errorsAt(int resolution) {
    const auto n = [](const glm::dvec3& x) { return 1.5 + 0.2 * std::sin(3.0 * x.x + 1.0) * std::cos(2.0 * x.y) * std::exp(x.z); };
    const Fields fields = samplesOf(glm::ivec3(resolution), 2.0 / resolution, n);
    const reference::GridField field(fields, Interpolation::kCubic);
    glm::dvec2 worst(0.0);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 x = within(fields.lattice, glm::fract(glm::dvec3(0.8192, 0.6711, 0.5497) * double(i)));
        const glm::dvec3 gradient =
            0.2 * std::exp(x.z) * glm::dvec3(3.0 * std::cos(3.0 * x.x + 1.0) * std::cos(2.0 * x.y),
                                             -2.0 * std::sin(3.0 * x.x + 1.0) * std::sin(2.0 * x.y),
                                             std::sin(3.0 * x.x + 1.0) * std::cos(2.0 * x.y));
        const reference::Optics found = field.optics(x);
        worst = glm::max(worst, glm::dvec2(std::abs(found.n - n(x)), glm::length(found.gradN - gradient)));
    }
    return worst;
}

TEST(CubicSpline, HasFourthOrderAndItsGradientTheThird) {
    const glm::dvec2 coarse = errorsAt(8), fine = errorsAt(16);
    // halving the voxel: 16 and 8 times less; half an order is what higher derivatives and the ends make of it
    EXPECT_GT(std::log2(coarse.x / fine.x), 3.5);
    EXPECT_GT(std::log2(coarse.y / fine.y), 2.5);
}

TEST(CubicSpline, CountsPlacesBeyondTheOutermostSamplesAsOnThem) {
    const Fields fields = samplesOf(glm::ivec3(6), 0.25, [](const glm::dvec3& x) { return 1.5 + 0.1 * x.x * x.y + 0.2 * x.z; });
    const reference::GridField field(fields, Interpolation::kCubic);
    const glm::dvec3 corner = fields.lattice.worldFromIndex(glm::ivec3(5));
    const reference::Optics at = field.optics(corner), beyond = field.optics(fields.lattice.max() + 0.1);
    EXPECT_EQ(at.n, beyond.n);
    EXPECT_EQ(at.gradN, beyond.gradN);
}

double kinkShareOf(const std::function<double(const glm::dvec3&)>& n) {
    return kinkShare(samplesOf(glm::ivec3(24), 1.0, n).ior);
}

TEST(CubicSpline, IsToldWhereSamplesAreKinked) {
    const double shift = 0.37;
    EXPECT_EQ(kinkShareOf([](const glm::dvec3&) { return 1.5; }), 0.0);
    // a cubic has no fourth differences
    EXPECT_LT(kinkShareOf([](const glm::dvec3& x) { return 1.5 + 1e-3 * x.x * x.x + 1e-4 * x.z * x.z * x.z; }), 1e-6);
    // Of an erfc by Fourier's transform: second differences have k⁻² e^(-b²k²) 16 sin⁴(k/2), fourth ones that times 16 sin⁴(k/2).
    const double width = 1.5;
    double second = 0.0, fourth = 0.0;
    for (double k = 0.005; k < std::numbers::pi; k += 0.01) {
        const double twice = std::pow(2.0 * std::sin(0.5 * k), 4.0), spectrum = twice * std::exp(-width * width * k * k) / (k * k);
        second += spectrum;
        fourth += twice * spectrum;
    }
    EXPECT_NEAR(kinkShareOf([&](const glm::dvec3& x) { return std::erfc((x.x - shift) / (std::numbers::sqrt2 * width)); }),
                fourth / (4.0 * second), 1e-4);
    // that part of the way between two voxels, whose centres are at halves
    const double t = shift + 0.5, squares = (1.0 - t) * (1.0 - t) + t * t;
    EXPECT_NEAR(kinkShareOf([&](const glm::dvec3& x) { return 1.5 + 0.1 * std::abs(x.x - shift); }),
                (6.0 * squares - 8.0 * t * (1.0 - t)) / (4.0 * squares), 1e-4);
    EXPECT_NEAR(kinkShareOf([&](const glm::dvec3& x) { return x.x < shift ? 1.0 : 1.5; }), 2.5, 1e-6);
}

} // namespace
} // namespace eikonal
