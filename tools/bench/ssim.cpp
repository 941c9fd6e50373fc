#include "tools/bench/ssim.h"

#include <array>
#include <cmath>

namespace eikonal::bench {

namespace {

constexpr int kWindow = 11;
constexpr double kSigma = 1.5;
constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;  // K1, K2 of the paper, for values up to 1

std::array<double, kWindow> windowWeights() {
    std::array<double, kWindow> weights{};
    double sum = 0.0;
    for (std::size_t i = 0; i < kWindow; ++i) {
        const double offset = double(i) - kWindow / 2;
        sum += weights[i] = std::exp(-0.5 * offset * offset / (kSigma * kSigma));
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

/// Weighted sums over a window.
struct Moments {
    double a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;

    double similarity() const {
        const double varianceA = aa - a * a, varianceB = bb - b * b, covariance = ab - a * b;
        return (2.0 * a * b + kC1) * (2.0 * covariance + kC2) /
               ((a * a + b * b + kC1) * (varianceA + varianceB + kC2));
    }
};

Moments momentsAt(const GreyImage& a, const GreyImage& b, int left, int top, const std::array<double, kWindow>& weights) {
    Moments m;
    for (int y = 0; y < kWindow; ++y) {
        for (int x = 0; x < kWindow; ++x) {
            const std::size_t pixel = std::size_t(top + y) * std::size_t(a.width) + std::size_t(left + x);
            const double weight = weights[std::size_t(x)] * weights[std::size_t(y)];
            const double p = a.values[pixel], q = b.values[pixel];
            m.a += weight * p;
            m.b += weight * q;
            m.aa += weight * p * p;
            m.bb += weight * q * q;
            m.ab += weight * p * q;
        }
    }
    return m;
}

} // namespace

double structuralDissimilarity(const GreyImage& a, const GreyImage& b) {
    const auto weights = windowWeights();
    double sum = 0.0;
    for (int top = 0; top + kWindow <= a.height; ++top) {
        for (int left = 0; left + kWindow <= a.width; ++left) sum += momentsAt(a, b, left, top, weights).similarity();
    }
    return 1.0 - sum / (double(a.width - kWindow + 1) * double(a.height - kWindow + 1));
}

} // namespace eikonal::bench
