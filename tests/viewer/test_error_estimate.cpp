// The error that an image says it has, against the one that it has: the same rays through the closed form of the index, in
// double precision. An estimate is right that is off by no more than a factor of three; nine in ten must be.
#include <cmath>

#include "common/physics.h"
#include "common/reference/stepper.h"
#include "tests/support/lumps.h"
#include "tests/support/synthetic_fields.h"
#include "viewer/error_estimate.h"
#include "viewer/render.h"

namespace eikonal {
namespace {

constexpr int kSize = 16;          // of the images [pixels]
constexpr int kSamplesPerEdge = 6; // of a pixel of the truth: its own noise is a tenth of that of four samples
constexpr double kStep = 0.02;     // of its rays [scene units]: those of fourth order err by less than 1e-4 of what is judged

/// The sky's radiance in the direction in which a ray of the camera leaves the box.
template <class Field>
glm::dvec3 radianceAlong(const Field& field, const Scene& scene, const glm::dvec3& direction) {
    const glm::dvec3 along = glm::normalize(direction), low(-1.0), high(1.0);
    const f64::BoxSpan span = f64::boxSpan(scene.camera.position, along, low, high);
    f64::Stepper<Field> stepper(field);
    f64::Ray ray{scene.camera.position + std::max(span.enter, 0.0) * along, along};
    for (int i = 0; span.leave > span.enter && i < 1000; ++i) {
        ray = stepper.stepRk4(ray, kStep).ray;
        if (std::max({std::abs(ray.x.x), std::abs(ray.x.y), std::abs(ray.x.z)}) > 1.0) break;
    }
    const auto& [horizon, zenith] = scene.environment.gradient;
    return f64::gradientRadiance(glm::normalize(ray.w), horizon, zenith);
}

/// RMS over pixels and bands, relative to the mean.
template <class Field>
double trueError(const Field& field, const Scene& scene, const RenderResult& image) {
    const double half = std::tan(glm::radians(scene.camera.fov) / 2.0);
    double squares = 0.0, sum = 0.0;
    for (int pixel = 0; pixel < kSize * kSize; ++pixel) {
        const glm::dvec2 corner(pixel % kSize, pixel / kSize);
        glm::dvec3 truth(0.0);
        for (int i = 0; i < kSamplesPerEdge * kSamplesPerEdge; ++i) {
            const glm::dvec2 within = (glm::dvec2(i % kSamplesPerEdge, i / kSamplesPerEdge) + 0.5) / double(kSamplesPerEdge);
            const glm::dvec2 screen = 2.0 * (corner + within) / double(kSize) - 1.0;
            truth += radianceAlong(field, scene, {screen.x * half, -screen.y * half, -1.0});
        }
        truth /= double(kSamplesPerEdge * kSamplesPerEdge);
        const glm::dvec3 error = glm::dvec3(image.radiance(pixel % kSize, pixel / kSize)) - truth;
        squares += glm::dot(error, error);
        sum += truth.x + truth.y + truth.z;
    }
    return std::sqrt(squares * 3.0 * kSize * kSize) / sum;
}

Scene sceneWith(double stepVoxels, int samples) {
    Scene scene = test::plainScene(glm::dvec3(0.0), 4.0, 24.0, kSize);
    scene.environment.gradient = {glm::dvec3(0.9, 0.5, 0.2), glm::dvec3(0.1, 0.3, 0.8)};
    scene.accuracy.stepVoxels = stepVoxels;
    scene.render.samples = samples;
    return scene;
}

/// Estimated over true error.
template <class Field>
double ratioOf(const Field& field, const Fields& fields, const Scene& scene) {
    const EffectSet effects = test::effectsOf(scene, fields);
    const RenderResult image = renderScene(test::sharedContext(), scene, fields, effects, nullptr);
    const ErrorEstimate estimate = estimateError(test::sharedContext(), scene, fields, effects, nullptr);
    EXPECT_EQ(estimate.pixels, std::size_t(kSize * kSize));  // there are too few to leave any out
    return estimate.total / trueError(field, scene, image);
}

bool isRight(double ratio) { return ratio > 1.0 / 3.0 && ratio < 3.0; }

TEST(ErrorEstimate, IsRightOnFiftyRandomFields) {
    constexpr double kSteps[] = {0.75, 1.5, 3.0, 6.0};
    int right = 0;
    for (unsigned seed = 0; seed < 50; ++seed) {
        const test::Lumps lumps(seed);
        const Fields fields =
            test::indexFields(test::cube(seed % 3 == 0 ? 16 : 32, 1.0), [&](const glm::dvec3& x) { return lumps.optics(x).n; });
        const double ratio = ratioOf(lumps, fields, sceneWith(kSteps[seed % 4], seed % 2 == 0 ? 1 : 4));
        right += isRight(ratio) ? 1 : 0;
        RecordProperty("ratio" + std::to_string(seed), std::to_string(ratio));
    }
    EXPECT_GE(right, 45);
}

TEST(ErrorEstimate, IsRightOnASphereWhateverTheSetting) {
    const Lattice lattice = test::cube(32, 1.0);
    const reference::SmoothedSphere sphere(0.6, 1.5, 1.5 * lattice.voxel);
    const Fields fields = test::indexFields(lattice, [&](const glm::dvec3& x) { return sphere.optics(x).n; });
    int right = 0, all = 0;
    for (const Interpolation interpolation : {Interpolation::kLinear, Interpolation::kCubic}) {
        for (const double step : {0.5, 1.0, 2.0, 4.0}) {
            for (const int samples : {1, 4, 9}) {
                Scene scene = sceneWith(step, samples);
                scene.accuracy.interpolation = interpolation;
                const double ratio = ratioOf(sphere, fields, scene);
                right += isRight(ratio) ? 1 : 0;
                ++all;
            }
        }
    }
    EXPECT_GE(10 * right, 9 * all);
}

} // namespace
} // namespace eikonal
