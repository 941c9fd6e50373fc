#include "viewer/sampling.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numbers>

#include "viewer/pixel_filter.h"

namespace eikonal::viewer {

namespace {

constexpr double kPlastic = 1.32471795724474602596;  // root of x^3 = x + 1, of which the R2 sequence is made

/// Place of a sample of the lens in its sequence before the pixel's own shift. The two halves have shifts of their own, so that
/// they are independent of each other, and count their samples apart.
glm::vec2 lensSequence(int sample) {
    return glm::vec2(glm::fract(double(sample / 2) * glm::dvec2(std::numbers::sqrt2, std::numbers::sqrt3)));
}

} // namespace

Sampling samplingOf(const RenderSettings& settings, const Camera& camera) {
    return {settings.filter, filterWidthOf(settings), 0.5 * camera.aperture};
}

int sampleOfRound(int round, const Sampling& sampling) {
    return sampling.hasLens() ? std::max(round - 1, 0) : round;
}

void configureRound(gpu::ViewBlock& view, int round, const Sampling& sampling) {
    const int sample = sampleOfRound(round, sampling);
    view.roundIndex = std::uint32_t(round);
    view.sampleWeight = 1.0f / float(sample + 1);
    view.halfWeight = isInHalf(sample) ? 1.0f / float(samplesInHalf(sample + 1)) : 0.0f;
    view.subPixel = subPixelPosition(sample, sampling.filter, sampling.filterWidth);
    view.lensRadius = round == 0 ? 0.0f : float(sampling.lensRadius);
    view.lensSequence = lensSequence(sample);
    view.lensHalf = isInHalf(sample) ? 0u : 1u;
}

glm::vec2 subPixelPosition(int sample, PixelFilter filter, double width) {
    const glm::dvec2 step(1.0 / kPlastic, 1.0 / (kPlastic * kPlastic));
    const glm::dvec2 uniform = glm::fract(0.5 + double(sample) * step);
    const glm::dvec2 place(filterPlace(filter, uniform.x), filterPlace(filter, uniform.y));
    return glm::vec2(0.5 + 0.5 * width * place);
}

bool isInHalf(int sample) { return std::popcount(unsigned(sample)) % 2 == 0; }

int samplesInHalf(int samples) { return samples / 2 + (samples % 2 == 1 && isInHalf(samples - 1) ? 1 : 0); }

} // namespace eikonal::viewer
