// Rays by the kernel that marches viewing rays, where arithmetic could fail: through centres, along edges and faces, from
// boundaries, without a slope, past a singularity, caught for ever.
#include <cmath>
#include <numbers>

#include "tests/stability/hard_cases.h"
#include "viewer/trace.h"

namespace eikonal {
namespace {

using glm::dvec3;

std::vector<TraceResult> traced(const Fields& fields, const std::vector<TraceRay>& rays) {
    return traceRays(test::sharedContext(), fields, test::effectsOf({}, fields), {}, rays);
}

void expectFinite(const TraceResult& end) {
    EXPECT_TRUE(std::isfinite(glm::dot(end.position, end.position))) << "position";
    EXPECT_NEAR(glm::length(end.direction), 1.0, 1e-6);
    EXPECT_TRUE(std::isfinite(end.opticalLength) && std::isfinite(end.length));
}

const std::vector<dvec3> kAxes{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {-1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, -1.0}};

TEST(StableRays, ThroughTheCentreOfASphereGoStraight) {
    for (const int resolution : {32, 33}) {  // the centre is a corner of voxels, and the middle of one
        const Fields fields = test::sphereFields(test::cube(resolution, 1.0), 0.6, 1.5, 0.06);
        std::vector<TraceRay> rays;
        for (const dvec3& axis : kAxes) rays.push_back({-2.0 * axis, axis});
        for (const TraceResult& end : traced(fields, rays)) {
            EXPECT_EQ(end.status, TraceStatus::kExited);
            EXPECT_NEAR(glm::length(end.position), 1.0, 1e-5);  // on the axis still: nothing turns it
            EXPECT_NEAR(end.opticalLength, 2.0 + 0.5 * 1.2, 0.01);  // the sphere's diameter, half a voxel's n off
        }
    }
}

TEST(StableRays, AlongEdgesOfVoxelsAndFacesOfTheDomain) {
    const Fields fields = test::sphereFields(test::cube(32, 1.0), 0.6, 1.5, 0.06);
    std::vector<TraceRay> rays;
    for (const double y : {0.0, 0.0625, 0.3125, 0.6, 1.0, -1.0}) {  // edges and planes between voxels; the faces
        for (const double z : {0.0, 0.0625, 0.6, 1.0, -1.0}) {
            rays.push_back({{-2.0, y, z}, {1.0, 0.0, 0.0}});
            rays.push_back({{y, -2.0, z}, {0.0, 1.0, 0.0}});
            rays.push_back({{z, y, -1.0}, {0.0, 0.0, 1.0}});  // from the face itself
        }
    }
    for (const TraceResult& end : traced(fields, rays)) {
        EXPECT_TRUE(end.status == TraceStatus::kExited || end.status == TraceStatus::kMissed) << traceStatusName(end.status);
        expectFinite(end);
    }
}

TEST(StableRays, FromABoundaryInwardsOutwardsAndAlong) {
    const Fields fields = test::sphereFields(test::cube(32, 1.0), 0.6, 1.5, 0.06);
    std::vector<TraceRay> across, along;
    for (int i = 0; i < 200; ++i) {
        const double angle = 2.399963229728653 * i, y = 1.0 - 2.0 * (i + 0.5) / 200.0, r = std::sqrt(1.0 - y * y);
        const dvec3 normal(r * std::cos(angle), y, r * std::sin(angle));
        across.push_back({0.6 * normal, normal});
        across.push_back({0.6 * normal, -normal});
        along.push_back({0.6 * normal, glm::cross(normal, dvec3(0.3, 0.5, 0.7))});
    }
    for (const TraceResult& end : traced(fields, across)) {
        expectFinite(end);
        EXPECT_EQ(end.status, TraceStatus::kExited);
    }
    for (const TraceResult& end : traced(fields, along)) {  // some are caught under the boundary
        expectFinite(end);
        EXPECT_TRUE(end.status == TraceStatus::kExited || end.status == TraceStatus::kLimit);
    }
}

TEST(StableRays, WithoutASlopeGoStraight) {
    const Fields fields = test::indexFields(test::cube(16, 1.0), [](const dvec3&) { return 1.4; });
    const dvec3 direction = glm::normalize(dvec3(0.3, 0.5, 0.7));
    const TraceResult end = traced(fields, {{-2.0 * direction, direction}}).front();
    EXPECT_NEAR(glm::length(end.direction - direction), 0.0, 1e-6);
    EXPECT_NEAR(end.opticalLength, 1.4 * end.length, 1e-5);
}

TEST(StableRays, PastTheSingularityOfEatonsLensTheyEnd) {
    // n = sqrt(2/r - 1): every ray comes back, on a half of Kepler's ellipse. n is infinite in the centre and cut off there.
    for (const int resolution : {32, 33}) {  // the centre is a corner of voxels, and the middle of one
        const double least = 1e-3;
        const Fields fields = test::indexFields(test::cube(resolution, 1.1), [least](const dvec3& x) {
            const double r = std::max(glm::length(x), least);
            return r < 1.0 ? std::sqrt(2.0 / r - 1.0) : 1.0;
        });
        std::vector<TraceRay> rays;
        for (int i = 0; i < 100; ++i) rays.push_back({{-2.0, 0.01 * (i + 0.5), 0.0}, {1.0, 0.0, 0.0}});
        const auto ends = traced(fields, rays);
        for (const TraceResult& end : ends) {
            expectFinite(end);
            EXPECT_TRUE(end.status == TraceStatus::kExited || end.status == TraceStatus::kLimit);
        }
    }
}

TEST(StableRays, TheWayBackLeadsToTheStart) {
    const Fields fields = test::sphereFields(test::cube(64, 1.0), 0.6, 1.5, 0.05);
    std::vector<TraceRay> there, back;
    for (int i = 0; i < 100; ++i) there.push_back({{-1.0, 0.0055 * i, 0.1}, {1.0, 0.0, 0.0}});
    const auto ends = traced(fields, there);
    for (const TraceResult& end : ends) back.push_back({end.position, -end.direction});
    const auto starts = traced(fields, back);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        // Steps begin elsewhere on the way back, so each way has its own error of a step of 0.75 voxel
        EXPECT_LE(glm::length(starts[i].position - there[i].origin), 0.01) << "ray " << i;
    }
}

TEST(StableRays, CriticalAngleOnVoxels) {
    // The plane x = 0 of glass and air, from both sides of the critical angle and from air at grazing incidence.
    const double voxel = 2.0 / 64.0, width = 1.5 * voxel;
    const Fields fields = test::indexFields(test::cube(64, 1.0), [width](const dvec3& x) {
        return 1.25 + 0.25 * std::erf((-x.x) / (std::numbers::sqrt2 * width));
    });
    const double critical = std::asin(1.0 / 1.5);
    for (const double degrees : {1.0, 0.1}) {
        for (const double side : {-1.0, 1.0}) {
            const double angle = critical + glm::radians(side * degrees);
            const dvec3 direction(std::cos(angle), std::sin(angle), 0.0);
            const TraceResult end = traced(fields, {{-0.4 * direction, direction}}).front();
            EXPECT_EQ(end.status, TraceStatus::kExited);
            EXPECT_EQ(end.direction.x > 0.0, side < 0.0) << degrees * side;
            // n sin θ; |w| - n is off by 1.2e-3 behind a boundary of 1.5 voxels in steps of 0.75
            const double n = 1.25 - 0.25 * std::erf(end.position.x / (std::numbers::sqrt2 * width));
            EXPECT_NEAR(n * end.direction.y, 1.5 * std::sin(angle), 2e-3) << degrees * side;
        }
    }
    for (const double degrees : {0.01, 0.001, -0.001, -0.01}) {  // here the step decides, and no ray may be lost
        const double angle = critical + glm::radians(degrees);
        const dvec3 direction(std::cos(angle), std::sin(angle), 0.0);
        const TraceResult end = traced(fields, {{-0.4 * direction, direction}}).front();
        expectFinite(end);
        EXPECT_EQ(end.status, TraceStatus::kExited);
    }
    for (const double degrees : {0.1, 0.01, 0.001}) {
        const double grazing = glm::radians(degrees);
        const dvec3 direction(-std::sin(grazing), std::cos(grazing), 0.0);
        const TraceResult end = traced(fields, {{{0.001, -1.0, 0.0}, direction}}).front();
        expectFinite(end);
        EXPECT_EQ(end.status, TraceStatus::kExited);
    }
}

TEST(StableRays, CaughtForEverTheyEndAtTheLimit) {
    const Fields fields = test::indexFields(test::cube(32, 1.0), [](const dvec3& x) { return 2.0 / (1.0 + glm::dot(x, x) / 0.25); });
    const TraceResult end = traced(fields, {{{0.5, 0.0, 0.0}, {0.0, 1.0, 0.0}}}).front();
    EXPECT_EQ(end.status, TraceStatus::kLimit);
    EXPECT_LE(end.evaluations, 4096u);
    EXPECT_NEAR(glm::length(end.position), 0.5, 0.03);  // on its circle still, after some 60 rounds
}

} // namespace
} // namespace eikonal
