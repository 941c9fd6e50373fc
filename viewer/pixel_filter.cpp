#include "viewer/pixel_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace eikonal::viewer {

namespace {

constexpr double kGaussianSigmas = 2.5;  // from its middle to its edge

// Weights of the cosines of the four-term window (F. J. Harris, 1978).
constexpr std::array kBlackmanHarris{0.35875, 0.48829, 0.14128, 0.01168};

double tentShare(double place) {
    return place < 0.0 ? 0.5 * (1.0 + place) * (1.0 + place) : 1.0 - 0.5 * (1.0 - place) * (1.0 - place);
}

double gaussianShare(double place) {
    const double edge = kGaussianSigmas / std::numbers::sqrt2;
    return 0.5 * (1.0 + std::erf(edge * place) / std::erf(edge));
}

double blackmanHarrisShare(double place) {
    double sum = kBlackmanHarris[0] * place;
    for (std::size_t i = 1; i < kBlackmanHarris.size(); ++i) {
        const double frequency = std::numbers::pi * double(i);
        sum += kBlackmanHarris[i] * std::sin(frequency * place) / frequency;
    }
    return 0.5 * (1.0 + sum / kBlackmanHarris[0]);
}

} // namespace

double filterWidthOf(const RenderSettings& settings) {
    constexpr std::array kWidths{1.0, 2.0, 2.5, 3.0};
    return settings.filterWidth.value_or(kWidths[std::size_t(settings.filter)]);
}

double filterShareBefore(PixelFilter filter, double place) {
    const double within = std::clamp(place, -1.0, 1.0);
    switch (filter) {
        case PixelFilter::kBox: return 0.5 * (1.0 + within);
        case PixelFilter::kTent: return tentShare(within);
        case PixelFilter::kGaussian: return gaussianShare(within);
        case PixelFilter::kBlackmanHarris: break;
    }
    return blackmanHarrisShare(within);
}

double filterPlace(PixelFilter filter, double share) {
    if (filter == PixelFilter::kBox || share == 0.5) return 2.0 * share - 1.0;
    double low = -1.0, high = 1.0;
    for (int halving = 0; halving < 52; ++halving) {
        const double middle = 0.5 * (low + high);
        (filterShareBefore(filter, middle) < share ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace eikonal::viewer
