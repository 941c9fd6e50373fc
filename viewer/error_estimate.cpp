#include "viewer/error_estimate.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "common/accuracy.h"
#include "viewer/image.h"

namespace eikonal {

namespace {

using Film = std::vector<gpu::FilmPixel>;

constexpr double kShareOfPixels = 1.0 / 64.0;
constexpr double kLeastPixels = 1024.0, kMostPixels = 2048.0;

/// Samples that those of the image are judged by: enough that one ray through a pixel's centre is not better than they are.
int moreThan(int samples) { return std::max(4 * samples, 16); }

/// So many pixels, evenly over the image, as if they were an image of their own.
glm::ivec2 sampleSize(const glm::ivec2& size) {
    const double pixels = double(size.x) * double(size.y);
    const double wanted = std::min(std::clamp(kShareOfPixels * pixels, kLeastPixels, kMostPixels), pixels);
    const glm::dvec2 edges = std::sqrt(wanted / pixels) * glm::dvec2(size);
    return glm::max(glm::ivec2(glm::round(edges)), glm::ivec2(1));
}

Film filmAfter(ProgressiveImage& image, int samples) {
    while (image.samples() < samples) image.addRays(image.mostRays());
    return image.film();
}

double rmsApart(const Film& a, const Film& b) {
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const glm::dvec3 difference = glm::dvec3(a[i].radiance) - glm::dvec3(b[i].radiance);
        squares += glm::dot(difference, difference);
    }
    return std::sqrt(squares / (3.0 * double(a.size())));
}

double meanOf(const Film& film) {
    double sum = 0.0;
    for (const gpu::FilmPixel& pixel : film) sum += pixel.radiance.x + pixel.radiance.y + pixel.radiance.z;
    return sum / (3.0 * double(film.size()));
}

/// What halving the step takes off an error is this share of it.
double shareLostByHalving(Integrator integrator) {
    const double order = integrator == Integrator::kEuler ? 1.0 : integrator == Integrator::kLeapfrog ? 2.0 : 4.0;
    return 1.0 - std::exp2(-order);
}

Film filmWithCubic(const gpu::Context& context, Scene scene, const Fields& fields, const EffectSet& effects,
                   const BakedLight* bake, const RenderOptions& options, double stepVoxels) {
    scene.accuracy.interpolation = Interpolation::kCubic;
    ProgressiveImage image(context, scene, fields, effects, bake, options);
    image.setStep(stepVoxels);
    image.setFrame(scene.render.size, {{0, 0}, scene.render.size});
    return filmAfter(image, scene.render.samples);
}

} // namespace

ErrorEstimate estimateError(const gpu::Context& context, const Scene& scene, const Fields& fields, const EffectSet& effects,
                            const BakedLight* bake, RenderOptions options) {
    const auto start = std::chrono::steady_clock::now();
    Scene sampled = scene;
    sampled.render.size = sampleSize(scene.render.size);
    options.pixelShare = glm::vec2(sampled.render.size) / glm::vec2(scene.render.size);
    options.tileRays = std::size_t(sampled.render.size.x) * std::size_t(sampled.render.size.y);
    options.progress = {};
    const double halfStep = 0.5 * stepVoxelsOf(scene.accuracy);
    const int samples = scene.render.samples;

    ProgressiveImage image(context, sampled, fields, effects, bake, options);
    image.setFrame(sampled.render.size, {{0, 0}, sampled.render.size});
    const Film own = filmAfter(image, samples);
    const Film sampledMore = filmAfter(image, moreThan(samples));
    image.setStep(halfStep);
    const Film steppedHalf = filmAfter(image, samples);

    const double mean = std::max(meanOf(own), 1e-30);
    ErrorEstimate estimate;
    estimate.pixels = own.size();
    estimate.step = rmsApart(own, steppedHalf) / shareLostByHalving(integratorOf(scene.accuracy)) / mean;
    // the samples of one are among those of the other: of independent errors that hides their share of the square
    estimate.sampling = rmsApart(own, sampledMore) / std::sqrt(1.0 - double(samples) / moreThan(samples)) / mean;
    const bool isLinear = interpolationOfImages(scene.accuracy) == Interpolation::kLinear;
    if (effects.has(Effect::kRefraction) && !fields.ior.empty() && isLinear) {
        const Film cubic = filmWithCubic(context, sampled, fields, effects, bake, options, halfStep);
        estimate.interpolation = rmsApart(steppedHalf, cubic) / mean;
    }
    estimate.total = std::hypot(estimate.step, estimate.interpolation, estimate.sampling);
    estimate.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return estimate;
}

} // namespace eikonal
