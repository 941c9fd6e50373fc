// Rays through voxel fields, by the march kernel, against closed forms and against the reference in double.
#include <cmath>
#include <optional>

#include "common/physics.h"
#include "common/reference/image_reference.h"
#include "tests/support/synthetic_fields.h"
#include "viewer/trace.h"

namespace eikonal {
namespace {

using test::sharedContext;

const Scene kScene;

std::vector<TraceResult> traced(const Fields& fields, const std::vector<TraceRay>& rays,
                                std::optional<double> stepVoxels = {},
                                StraightFlights flights = StraightFlights::kTaken) {
    Accuracy accuracy;
    accuracy.stepVoxels = stepVoxels;
    return traceRays(sharedContext(), fields, test::effectsOf(kScene, fields), accuracy, rays, flights);
}

/// Rays along a direction close to +z through a disc of `radius`, from in front of the domain.
std::vector<TraceRay> parallelRays(double radius, int count, const glm::dvec3& direction, double distance) {
    std::vector<TraceRay> rays;
    const glm::dvec3 forward = glm::normalize(direction);
    const glm::dvec3 side = glm::normalize(glm::cross(forward, glm::dvec3(0.0, 1.0, 0.0)));
    const glm::dvec3 up = glm::cross(side, forward);
    for (int i = 0; i < count; ++i) {
        const double r = radius * std::sqrt((i + 0.5) / count);
        const double angle = 2.399963229728653 * i;
        rays.push_back({side * (r * std::cos(angle)) + up * (r * std::sin(angle)) - forward * distance, forward});
    }
    return rays;
}

template <class Exact>
double rmsDirectionError(const std::vector<TraceRay>& rays, const std::vector<TraceResult>& results, Exact exact) {
    double sum = 0.0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(results[i].status, TraceStatus::kExited);
        const glm::dvec3 error = results[i].direction - exact(rays[i], results[i]);
        sum += glm::dot(error, error);
    }
    return std::sqrt(sum / double(rays.size()));
}

/// The ray turned towards the axis through the origin, in its own plane, by an angle.
glm::dvec3 turnedInwards(const TraceRay& ray, double angle) {
    const glm::dvec3 forward = glm::normalize(ray.direction);
    const glm::dvec3 offset = ray.origin - forward * glm::dot(ray.origin, forward);
    return forward * std::cos(angle) - glm::normalize(offset) * std::sin(angle);
}

double impactOf(const TraceRay& ray) {
    return glm::length(glm::cross(ray.origin, glm::normalize(ray.direction)));
}

TEST(Trace, LuneburgLensTurnsByArcsineOfTheImpactParameter) {
    const Fields fields = test::indexFields(test::cube(128, 1.125), [](const glm::dvec3& x) {
        return std::sqrt(std::max(2.0 - glm::dot(x, x), 1.0));
    });
    const auto rays = parallelRays(0.95, 2000, {0.2, 0.1, 1.0}, 3.0);
    const double rms = rmsDirectionError(rays, traced(fields, rays), [](const TraceRay& ray, const TraceResult&) {
        return turnedInwards(ray, std::asin(impactOf(ray)));
    });
    RecordProperty("rms", std::to_string(rms));
    EXPECT_LE(rms, 1.2e-3);
}

/// Direction at x of the fish-eye's ray from a start: the circle through the start and its image -a^2 x0/|x0|^2.
glm::dvec3 fishEyeDirection(const TraceRay& ray, const glm::dvec3& x, double a2) {
    const glm::dvec3 start = glm::normalize(ray.direction);
    const glm::dvec3 chord = -ray.origin * (1.0 + a2 / glm::dot(ray.origin, ray.origin));
    const glm::dvec3 plane = glm::normalize(glm::cross(chord, start));
    const glm::dvec3 outward = glm::cross(plane, start);
    const glm::dvec3 centre = ray.origin + outward * (glm::dot(chord, chord) / (2.0 * glm::dot(chord, outward)));
    const double sense = glm::dot(glm::cross(plane, ray.origin - centre), start) > 0.0 ? 1.0 : -1.0;
    return sense * glm::normalize(glm::cross(plane, x - centre));
}

TEST(Trace, FishEyeFollowsCircles) {
    const double a2 = 0.49, edge = 0.98;
    const std::uint32_t onePass = 200;  // evaluations; circles within the domain go on for ever
    const Fields fields = test::indexFields(test::cube(128, 1.125),
                                            [&](const glm::dvec3& x) { return 3.0 / (1.0 + glm::dot(x, x) / a2); });
    std::vector<TraceRay> rays;
    for (int i = 0; i < 500; ++i) {
        const double angle = 2.399963229728653 * i;
        const double r = 0.1 + 0.8 * (i % 50) / 50.0;
        rays.push_back({{r * std::cos(angle), r * std::sin(angle), 0.1},
                        {std::sin(3.0 * angle), 0.4, std::cos(3.0 * angle)}});
    }
    double sum = 0.0;
    std::size_t count = 0;
    for (const TracePoint& point : tracePaths(sharedContext(), fields, test::effectsOf(kScene, fields), {}, rays)) {
        if (glm::length(point.at.position) > edge || point.at.evaluations > onePass) continue;
        const glm::dvec3 error = point.at.direction - fishEyeDirection(rays[point.ray], point.at.position, a2);
        sum += glm::dot(error, error);
        ++count;
    }
    const double rms = std::sqrt(sum / double(count));
    RecordProperty("rms", std::to_string(rms));
    EXPECT_LE(rms, 7e-4);
}

TEST(Trace, GradedRodIsHarmonic) {
    const double n0 = 1.8, radius = 0.7;
    const double g2 = (1.0 - 1.0 / (n0 * n0)) / (radius * radius);
    const Fields fields = test::indexFields(test::cube(128, 1.125), [&](const glm::dvec3& x) {
        return n0 * std::sqrt(std::max(1.0 - g2 * (x.x * x.x + x.y * x.y), 1.0 / (n0 * n0)));
    });
    const auto rays = parallelRays(0.3, 1000, {0.0, 0.0, 1.0}, 3.0);
    const double rms = rmsDirectionError(rays, traced(fields, rays), [&](const TraceRay& ray, const TraceResult& end) {
        const glm::dvec3 offset(ray.origin.x, ray.origin.y, 0.0);
        const double n = n0 * std::sqrt(1.0 - g2 * glm::dot(offset, offset));
        const double tau = (end.position.z + 1.125) / n;
        const double k = n0 * std::sqrt(g2);
        return glm::normalize(glm::dvec3(0.0, 0.0, n) - offset * (k * std::sin(k * tau)));
    });
    RecordProperty("rms", std::to_string(rms));
    EXPECT_LE(rms, 2e-4);
}

/// Direction behind a smoothed sphere by leapfrog in double with steps so small that its error is below 1e-7.
glm::dvec3 directionBehind(const reference::SmoothedSphere& sphere, const TraceRay& input) {
    f64::Ray ray = {input.origin + glm::normalize(input.direction) * 1.9, glm::normalize(input.direction)};
    const double h = 1e-3;
    for (int i = 0; i < 2300; ++i) {
        ray = f64::driftByLength(ray, 0.5 * h);
        ray = f64::driftByLength(f64::kickByLength(ray, sphere.optics(ray.x).gradN, h), 0.5 * h);
    }
    return glm::normalize(ray.w);
}

TEST(Trace, SmoothedSphereRefractsLikeItsProfile) {
    const double b = 0.04;
    const Fields fields = test::sphereFields(test::cube(128, 1.125), 0.8, 1.5, b);
    const auto rays = parallelRays(0.76, 500, {0.1, -0.2, 1.0}, 3.0);
    const reference::SmoothedSphere sphere(0.8, 1.5, b);
    const double rms = rmsDirectionError(rays, traced(fields, rays), [&](const TraceRay& ray, const TraceResult&) {
        return directionBehind(sphere, ray);
    });
    RecordProperty("rms", std::to_string(rms));
    EXPECT_LE(rms, 1e-3);
}

TEST(Trace, AgreesWithTheReferenceThroughTheSameField) {
    const Fields fields = test::sphereFields(test::cube(64, 1.0), 0.7, 1.5, 0.05);
    const auto darkness = [](const glm::dvec3&) { return glm::dvec3(0.0); };
    const reference::ImageScene scene{.field = reference::GridField(fields), .background = darkness};
    const auto rays = parallelRays(0.68, 300, {0.3, 0.2, 1.0}, 3.0);
    for (const double stepVoxels : {0.5, 1.0, 3.0}) {
        // the reference steps through everything: flights would move the places at which the field is looked at
        const auto results = traced(fields, rays, stepVoxels, StraightFlights::kNone);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto exact = reference::followRay(scene, rays[i].origin, rays[i].direction, {.stepVoxels = stepVoxels});
            EXPECT_LE(glm::length(results[i].position - exact.position), 1e-4) << "ray " << i << ", step " << stepVoxels;
            EXPECT_LE(glm::length(results[i].direction - exact.direction), 1e-4) << "ray " << i;
            EXPECT_NEAR(results[i].opticalLength, exact.opticalLength, 1e-4) << "ray " << i;
        }
    }
}

TEST(Trace, PathsEndWhereRaysEndWhateverTheSlices) {
    const Fields fields = test::sphereFields(test::cube(32, 1.0), 0.7, 1.5, 0.1);
    const auto rays = parallelRays(0.6, 20, {0.0, 0.0, 1.0}, 3.0);
    const auto ends = traced(fields, rays);
    const auto points = tracePaths(sharedContext(), fields, test::effectsOf(kScene, fields), {}, rays);
    std::vector<const TraceResult*> last(rays.size(), nullptr);
    for (const TracePoint& point : points) last[point.ray] = &point.at;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_NE(last[i], nullptr);
        // A slice's end cuts a drift that is else taken in one: some 60 roundings of single precision more.
        constexpr double kRounding = 1e-6;
        EXPECT_LT(glm::distance(last[i]->position, ends[i].position), kRounding);
        EXPECT_LT(glm::distance(last[i]->direction, ends[i].direction), kRounding);
        EXPECT_NEAR(last[i]->opticalLength, ends[i].opticalLength, kRounding * ends[i].opticalLength);
        EXPECT_EQ(last[i]->evaluations, ends[i].evaluations);
    }
}

TEST(Trace, RaysThatOnlyBendGoTheWayOfThoseInMatter) {
    const Lattice lattice = test::cube(32, 1.0);
    Fields fields = test::indexFields(lattice, [](const glm::dvec3& x) { return 1.5 + 0.3 * x.x - 0.2 * x.y * x.z; });
    auto rays = parallelRays(1.6, 300, {0.7, -0.5, 0.6}, 3.0);  // past edges and corners too
    for (const TraceRay& along : parallelRays(0.99, 100, {1.0, 0.0, 0.02}, 3.0)) rays.push_back(along);
    const auto free = traced(fields, rays);
    fields.sigmaA = test::boxGrid(lattice, glm::dvec3(-1.0), glm::dvec3(1.0), glm::vec3(1e-6f));  // other kernels, the same way
    const auto plain = traced(fields, rays);
    int entered = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        constexpr double kRounding = 2e-6;  // of some 60 steps in single precision, in other orders
        constexpr double kAlong = 1e-5;     // as far as that moves the place where a ray leaves by a face that it grazes
        ASSERT_EQ(free[i].status, plain[i].status);
        EXPECT_LT(glm::distance(free[i].position, plain[i].position), kAlong) << i;
        EXPECT_LT(glm::distance(free[i].direction, plain[i].direction), kRounding) << i;
        EXPECT_NEAR(free[i].length, plain[i].length, kAlong) << i;
        EXPECT_NEAR(free[i].opticalLength, plain[i].opticalLength, 2.0 * kAlong) << i;
        entered += free[i].status == TraceStatus::kExited ? 1 : 0;
    }
    EXPECT_GT(entered, 200);
}

TEST(Trace, StraightRaysKeepDirectionAndMeasureTheBox) {
    const Fields fields = test::uniformFields(test::cube(16, 1.0), 1.5);
    const auto results = traced(fields, {{{0.1, 0.2, -5.0}, {0.0, 0.0, 2.0}},     // through
                                         {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}},      // from inside
                                         {{0.0, 3.0, 0.0}, {1.0, 0.0, 0.0}},      // past it
                                         {{0.0, 0.0, 3.0}, {0.0, 0.0, 1.0}}});    // away from it
    EXPECT_EQ(results[0].status, TraceStatus::kExited);
    EXPECT_EQ(results[0].direction, glm::dvec3(0.0, 0.0, 1.0));
    EXPECT_NEAR(results[0].length, 2.0, 1e-5);
    EXPECT_NEAR(results[0].opticalLength, 3.0, 1e-5);
    EXPECT_EQ(results[0].position.z, 1.0);
    EXPECT_NEAR(results[1].length, 1.0, 1e-5);
    EXPECT_EQ(results[2].status, TraceStatus::kMissed);
    EXPECT_EQ(results[2].position, glm::dvec3(0.0, 3.0, 0.0));
    EXPECT_EQ(results[2].evaluations, 0u);
    EXPECT_EQ(results[3].status, TraceStatus::kMissed);
    EXPECT_EQ(results[3].direction, glm::dvec3(0.0, 0.0, 1.0));
}

/// The device knows single precision only: it takes rays from near the domain.
TEST(Trace, RaysMayComeFromAfarAndHaveDirectionsOfAnyLength) {
    const Fields fields = test::uniformFields(test::cube(16, 1.0));
    for (const double far : {3.0, 1e3, 1e6, 1e9, 1e12}) {
        for (const double length : {1e-200, 1.0, 1e300}) {
            const auto results = traced(fields, {{{-far, 0.25 - far, 0.0}, {length, length, 0.0}},   // through
                                                 {{-far, 2.25 - far, 0.0}, {length, length, 0.0}},   // past it
                                                 {{-far, -2.0 * far, 0.0}, {length, length, 0.0}}});  // far past it
            // What is left of y = x + 0.25 in a double so far away.
            const double tolerance = 1e-6 + 4e-16 * far;
            EXPECT_EQ(results[0].status, TraceStatus::kExited) << far << " " << length;
            EXPECT_NEAR(results[0].position.x, 0.75, tolerance) << far << " " << length;
            EXPECT_NEAR(results[0].position.y, 1.0, tolerance) << far << " " << length;
            EXPECT_EQ(results[1].status, TraceStatus::kMissed) << far << " " << length;
            EXPECT_EQ(results[2].status, TraceStatus::kMissed) << far << " " << length;
        }
    }
}

TEST(Trace, NoRaysAndOneVoxelAreFine) {
    const Fields fields = test::uniformFields(test::cube(1, 1.0));
    EXPECT_TRUE(traced(fields, {}).empty());
    const auto results = traced(fields, {{{0.0, 0.0, -2.0}, {0.0, 0.0, 1.0}}});
    EXPECT_NEAR(results[0].length, 2.0, 1e-6);
}

TEST(Trace, CountsOpticalDepthAndOpaqueHits) {
    const Lattice lattice = test::cube(32, 1.0);
    Fields fields = test::uniformFields(lattice);
    fields.sigmaA = test::boxGrid(lattice, {-1.0, -1.0, -0.4}, {1.0, 1.0, 0.3}, {0.5f, 1.0f, 2.0f});
    fields.albedo = DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.5f));
    fields.opaque = test::boxCoverage(lattice, {-1.0, -1.0, 0.61}, {1.0, 1.0, 0.9});
    const double aVoxel = 1.0;  // steps that sum linear interpolation over a sharp face exactly
    const auto results =
        traced(fields, {{{0.03, 0.01, -3.0}, {0.0, 0.0, 1.0}}, {{0.0, 0.0, -0.9}, {0.0, 0.0, -1.0}}}, aVoxel);
    EXPECT_EQ(results[0].status, TraceStatus::kAbsorbed);
    EXPECT_NEAR(results[0].position.z, 0.61, 0.01);
    EXPECT_NEAR(results[0].depth.x, 0.35, 1e-4);
    EXPECT_NEAR(results[0].depth.z, 1.4, 1e-4);
    EXPECT_EQ(results[1].status, TraceStatus::kExited);
}

TEST(Trace, FilteringByHandAgreesWithTheTextureUnit) {
    if (!sharedContext().limits().exactLinearFiltering) GTEST_SKIP() << "the texture unit is not exact here";
    const Fields fields = test::sphereFields(test::cube(32, 1.0), 0.7, 1.5, 0.1);
    const auto rays = parallelRays(0.6, 100, {0.1, 0.2, 1.0}, 3.0);
    const auto byUnit = traced(fields, rays);
    std::vector<TraceResult> byHand;
    {
        const gpu::Context manual = gpu::Context::windowless({.forceManualFiltering = true});
        byHand = traceRays(manual, fields, test::effectsOf(kScene, fields), {}, rays);
    }
    sharedContext().makeCurrent();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_LE(glm::length(byUnit[i].direction - byHand[i].direction), 2e-5) << "ray " << i;
    }
}

} // namespace
} // namespace eikonal
