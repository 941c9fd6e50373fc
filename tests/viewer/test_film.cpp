// Filters of pixels, and the noise of a film.
#include <array>
#include <cmath>
#include <numbers>

#include "tests/viewer/defocused_edge.h"
#include "viewer/pixel_filter.h"
#include "viewer/render.h"

namespace eikonal {
namespace {

constexpr std::array kFilters{PixelFilter::kBox, PixelFilter::kTent, PixelFilter::kGaussian, PixelFilter::kBlackmanHarris};

RenderResult rendered(const Scene& scene, const Fields& fields) {
    return renderScene(test::sharedContext(), scene, fields, test::effectsOf(scene, fields), nullptr);
}

/// Variance of a filter's weight between -1 and 1, from the formulas of the weights.
double varianceOf(PixelFilter filter) {
    if (filter == PixelFilter::kBox) return 1.0 / 3.0;
    if (filter == PixelFilter::kTent) return 1.0 / 6.0;
    if (filter == PixelFilter::kGaussian) {  // cut off at 2.5 sigmas
        const double edge = 2.5, density = std::exp(-0.5 * edge * edge) / std::sqrt(2.0 * std::numbers::pi);
        return (1.0 - 2.0 * edge * density / std::erf(edge / std::numbers::sqrt2)) / (edge * edge);
    }
    const std::array weights{0.35875, 0.48829, 0.14128, 0.01168};
    double sum = 2.0 / 3.0 * weights[0];
    for (int k = 1; k < 4; ++k) {
        sum += weights[std::size_t(k)] * 4.0 * (k % 2 == 0 ? 1.0 : -1.0) / std::pow(k * std::numbers::pi, 2.0);
    }
    return sum / (2.0 * weights[0]);
}

TEST(PixelFilter, WeightsSumToOneAndAreEven) {
    for (const PixelFilter filter : kFilters) {
        EXPECT_EQ(viewer::filterShareBefore(filter, -1.0), 0.0);
        EXPECT_NEAR(viewer::filterShareBefore(filter, 1.0), 1.0, 1e-15);
        for (double place = -1.0; place < 1.0; place += 0.01) {
            const double share = viewer::filterShareBefore(filter, place);
            EXPECT_LE(share, viewer::filterShareBefore(filter, place + 0.01));
            EXPECT_NEAR(share + viewer::filterShareBefore(filter, -place), 1.0, 1e-14);
            EXPECT_NEAR(viewer::filterShareBefore(filter, viewer::filterPlace(filter, share)), share, 1e-14);
        }
    }
}

TEST(PixelFilter, SpreadsSamplesByItsWeight) {
    constexpr int kSamples = 4096;
    constexpr double kWidth = 3.0;
    for (const PixelFilter filter : kFilters) {
        glm::dvec2 mean(0.0), square(0.0);
        for (int i = 0; i < kSamples; ++i) {
            const glm::dvec2 offset = glm::dvec2(viewer::subPixelPosition(i, filter, kWidth)) - 0.5;
            ASSERT_LE(std::max(std::abs(offset.x), std::abs(offset.y)), 0.5 * kWidth);
            mean += offset / double(kSamples);
            square += offset * offset / double(kSamples);
        }
        const double variance = 0.25 * kWidth * kWidth * varianceOf(filter);
        for (int axis = 0; axis < 2; ++axis) {
            // Low discrepancy: of 4096 points in an interval none is amiss by more than some ten places.
            EXPECT_NEAR(mean[axis], 0.0, 10.0 * kWidth / kSamples);
            EXPECT_NEAR(square[axis], variance, 10.0 * kWidth * kWidth / kSamples);
        }
    }
    EXPECT_EQ(viewer::subPixelPosition(0, PixelFilter::kBlackmanHarris, kWidth), glm::vec2(0.5f));
}

/// A thin sheet whose radiance rises linearly from left to right.
Fields rampFields() {
    Fields fields = test::uniformFields(test::cube(32, 1.0));
    fields.emission = DenseGrid<glm::vec3>(fields.lattice.size, glm::vec3(0.0f));
    test::forEachVoxel(fields.lattice, [&](const glm::ivec3& v) {
        if (v.z == 16) fields.emission.at(v) = glm::vec3(float(20.0 + 10.0 * fields.lattice.worldFromIndex(v).x));
    });
    return fields;
}

TEST(PixelFilter, KeepsALinearRampLinear) {
    const Fields fields = rampFields();
    Scene scene = test::plainScene(glm::dvec3(0.0), 400.0, 0.2, 16);  // nearly parallel rays, 0.7 to either side
    const RenderResult unfiltered = rendered(scene, fields);
    const double slope = (unfiltered.radiance(15, 8).g - unfiltered.radiance(0, 8).g) / 15.0;
    ASSERT_GT(slope, 0.02);
    scene.render.samples = 32;
    for (const PixelFilter filter : kFilters) {
        scene.render.filter = filter;
        const RenderResult image = rendered(scene, fields);
        double offset = 0.0;
        for (int i = 0; i < scene.render.samples; ++i) {
            offset += viewer::subPixelPosition(i, filter, viewer::filterWidthOf(scene.render)).x - 0.5;
        }
        const double shift = slope * offset / scene.render.samples;
        EXPECT_LT(std::abs(offset / scene.render.samples), 0.1);  // of a pixel
        for (int x = 0; x < 16; ++x) {
            // Rounding of the places of rays 400 away is 3e-5, 3e-4 of what lies between two pixels.
            EXPECT_NEAR(image.radiance(x, 8).g, unfiltered.radiance(x, 8).g + shift, 2e-3 * slope) << x;
        }
    }
}

TEST(PixelFilter, RepeatsToTheBit) {
    const test::DefocusedEdge edge;
    Scene scene = edge.scene;
    scene.render.samples = 5;
    scene.render.filter = PixelFilter::kBlackmanHarris;
    EXPECT_EQ(rendered(scene, edge.fields).channels[0].values, rendered(scene, edge.fields).channels[0].values);
}

/// Root mean square of the difference between two images, over the mean of the second.
double relativeError(const RenderResult& image, const RenderResult& truth) {
    double squares = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < image.channels[1].values.size(); ++i) {
        const double difference = double(image.channels[1].values[i]) - double(truth.channels[1].values[i]);
        squares += difference * difference;
        sum += double(truth.channels[1].values[i]);
    }
    return std::sqrt(squares * double(image.channels[1].values.size())) / sum;
}

/// Another run of the same picture with so many samples that its own error does not count.
RenderResult truthOf(const test::DefocusedEdge& edge) {
    Scene scene = edge.scene;
    scene.render.samples = 2048;
    return rendered(scene, edge.fields);
}

TEST(FilmNoise, IsTheErrorAndFallsWithTheRootOfSamples) {
    test::DefocusedEdge edge;
    const RenderResult truth = truthOf(edge);
    double first = 0.0;
    for (const int samples : {8, 32, 128}) {
        edge.scene.render.samples = samples;
        const RenderResult image = rendered(edge.scene, edge.fields);
        EXPECT_EQ(image.statistics.samples, samples);
        const double error = relativeError(image, truth);
        // A sum over some five hundred pixels in the blur, each known by one difference: 1/sqrt(2 · 500) of it at two sigmas,
        // and half as much again, since places within a pixel are the same in all and not independent.
        EXPECT_NEAR(image.statistics.noise, error, 0.15 * error) << samples;
        if (first == 0.0) first = error * std::sqrt(8.0);
        // Low-discrepancy places do no worse than random ones.
        EXPECT_LT(error * std::sqrt(samples), 1.05 * first) << samples;
    }
}

TEST(FilmNoise, EndsSamplingAtItsTarget) {
    test::DefocusedEdge edge;
    const RenderResult truth = truthOf(edge);
    edge.scene.render.samples = 1024;
    for (const double target : {0.1, 0.03}) {
        edge.scene.render.noise = target;
        const RenderResult image = rendered(edge.scene, edge.fields);
        EXPECT_LE(image.statistics.noise, target);
        EXPECT_LT(image.statistics.samples, 512.0) << "not all that there might be";
        EXPECT_LE(relativeError(image, truth), 1.1 * target);  // an estimate from five hundred pixels that happened to be low
        EXPECT_GE(relativeError(image, truth), 0.5 * target);  // sampling goes on by an eighth, and steeper than by the root
    }
}

TEST(FilmNoise, IsUnknownFromOneSampleAndNoneWhereNothingVaries) {
    Scene scene = test::plainScene(glm::dvec3(1.0), 4.0, 10.0, 8);
    const Fields fields = test::uniformFields(test::cube(4, 1.0));
    EXPECT_TRUE(std::isinf(rendered(scene, fields).statistics.noise));
    scene.render.samples = 64;
    scene.render.noise = 1e-3;
    const RenderResult image = rendered(scene, fields);
    EXPECT_EQ(image.statistics.samples, 4.0);
    EXPECT_NEAR(image.statistics.noise, 0.0, 1e-6);
}

TEST(FilmNoise, LooksMoreSeldomAsSamplesGrow) {
    EXPECT_FALSE(viewer::isNoiseLookedAt(3));
    int looks = 0, last = 4;
    for (int samples = 4; samples <= 4096; ++samples) {
        if (!viewer::isNoiseLookedAt(samples)) continue;
        EXPECT_LE(samples, last + std::max(2, last / 8));
        last = samples;
        ++looks;
    }
    EXPECT_LE(looks, 100);
}

TEST(FilmNoise, HalvesTakeOneOfEveryTwo) {
    int counted = 0;
    for (int sample = 0; sample < 100; ++sample) {
        counted += viewer::isInHalf(sample) ? 1 : 0;
        EXPECT_EQ(viewer::samplesInHalf(sample + 1), counted);
        EXPECT_NE(viewer::isInHalf(2 * sample), viewer::isInHalf(2 * sample + 1));
    }
}

} // namespace
} // namespace eikonal
