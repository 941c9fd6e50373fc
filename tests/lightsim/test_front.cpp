// Wavefronts at given times: surfaces of constant optical path, with the power of their light on them.
#include <algorithm>
#include <numbers>

#include "lightsim/emit.h"
#include "lightsim/front.h"
#include "lightsim/settings.h"
#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

std::vector<FrontPatch> fronts(const Scene& scene, const Fields& fields, const std::vector<double>& times,
                               const BakeOptions& options = {}) {
    return frontsAt(test::sharedContext(), scene, fields, decideEffects(scene, fields), times, options);
}

/// Of the two triangles that a patch is cut into.
double areaOf(const FrontPatch& patch) {
    const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
        const glm::dvec3 origin(patch.corners[a]);
        return 0.5 * glm::length(glm::cross(glm::dvec3(patch.corners[b]) - origin, glm::dvec3(patch.corners[c]) - origin));
    };
    return triangle(0, 1, 2) + triangle(0, 2, 3);
}

TEST(Front, OfAPointLightIsASphereThatCarriesItsPower) {
    const PointLight light{{0.05, -0.02, 0.01}, glm::dvec3(1.0, 2.0, 4.0)};
    const Fields fields = test::uniformFields(test::cube(32, 1.0));
    for (const double time : {0.21, 0.9}) {  // no multiples of a step
        glm::dvec3 power(0.0);
        for (const FrontPatch& patch : fronts(test::sceneWith(light), fields, {time})) {
            for (const glm::vec3& corner : patch.corners) {
                EXPECT_NEAR(glm::distance(glm::dvec3(corner), light.position), time, 1e-5);  // 30 steps in single precision
            }
            EXPECT_EQ(patch.opticalTime, time);
            EXPECT_FALSE(patch.folded);
            power += glm::dvec3(patch.irradiance) * areaOf(patch);
        }
        for (int band = 0; band < 3; ++band) {
            // a patch spans an eighth of a radian at most: its triangles lean apart by a sixteenth, 1e-3 of their area
            EXPECT_NEAR(power[band], light.power[band], 1e-3 * light.power[band]);
        }
    }
}

const Scene kBeam = test::sceneWith(DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0)});

/// The surface that the scene's only beam is launched from.
bake::LaunchFrame launchFrameOf(const Scene& scene, const Fields& fields) {
    Accuracy accuracy = scene.accuracy;
    accuracy.deposit = Deposit::kSplat;  // what fronts are made of
    const bake::Criteria criteria = bake::criteriaOf(accuracy, fields);
    return bake::launchGrids({scene.lights, {}}, fields.lattice, criteria).frames.front();
}

glm::dvec3 launchedAt(const bake::LaunchFrame& frame, const glm::vec2& launch) {
    return glm::dvec3(frame.centre + frame.a * launch.x + frame.b * launch.y);
}

double axisDistance(const glm::dvec3& x) { return std::hypot(x.y, x.z); }

/// τ at which a ray that enters the Luneburg lens with impact parameter sqrt(1 - c^2) has an optical path t behind it:
/// t = τ + c sin²τ, the integral of n² = 2 - |x(τ)|².
double luneburgTau(double t, double c) {
    double low = 0.0, high = std::numbers::pi;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (middle + c * std::sin(middle) * std::sin(middle) < t ? low : high) = middle;
    }
    return low;
}

TEST(Front, InALuneburgLensFollowsTheClosedForm) {
    const Lattice lattice = test::cube(64, 1.125);
    const Fields fields = test::indexFields(lattice, [](const glm::dvec3& x) {
        return std::sqrt(std::max(2.0 - glm::dot(x, x), 1.0));
    });
    const bake::LaunchFrame frame = launchFrameOf(kBeam, fields);
    const double time = 2.0;
    double squares = 0.0;
    int count = 0;
    for (const FrontPatch& patch : fronts(kBeam, fields, {time})) {
        const glm::dvec3 entry = launchedAt(frame, patch.launchMin);
        const double impact = axisDistance(entry);
        if (impact > 0.9) {
            continue;  // grazing rays stay near the rim, where the index has a kink
        }
        const double c = std::sqrt(1.0 - impact * impact);
        const double tau = luneburgTau(time - (lattice.extent().x * 0.5 - c), c);
        const glm::dvec3 expected = glm::dvec3(-c, entry.y, entry.z) * std::cos(tau) + glm::dvec3(std::sin(tau), 0.0, 0.0);
        const double error = glm::distance(glm::dvec3(patch.corners[0]), expected);
        // the kink at the rim is blurred over a voxel: 0.03 voxels RMS as measured, 0.11 at worst
        EXPECT_LT(error, 0.2 * lattice.voxel);
        squares += error * error;
        ++count;
    }
    EXPECT_GT(count, 2000);  // patches of at most a voxel on a disc of 0.9 * 64/2.25 voxels radius
    EXPECT_LT(std::sqrt(squares / count), 0.05 * lattice.voxel);
}

/// Corners that have crossed the axis of the sphere, which is the beam's.
int cornersAcross(const FrontPatch& patch, const bake::LaunchFrame& frame) {
    const glm::dvec3 start = launchedAt(frame, 0.5f * (patch.launchMin + patch.launchMax));
    return int(std::count_if(patch.corners.begin(), patch.corners.end(), [&](const glm::vec3& corner) {
        return corner.y * start.y + corner.z * start.z < 0.0;
    }));
}

TEST(Front, IsTurnedInsideOutBetweenTheFociOfEachRay) {
    const Fields fields = test::clearSphere(48);
    const bake::LaunchFrame frame = launchFrameOf(kBeam, fields);
    for (const FrontPatch& patch : fronts(kBeam, fields, {1.6})) {  // within the sphere
        EXPECT_FALSE(patch.folded);
    }
    // neighbours in a meridional plane meet first, then all rays of a cone on the axis
    int folded = 0;
    for (const FrontPatch& patch : fronts(kBeam, fields, {2.2})) {
        const bool throughTheSphere = axisDistance(launchedAt(frame, patch.launchMin)) < 0.5;
        if (patch.folded && throughTheSphere) {
            EXPECT_EQ(cornersAcross(patch, frame), 0);
            ++folded;
        }
    }
    EXPECT_GT(folded, 0);
    const auto behind = fronts(kBeam, fields, {2.6});  // behind both: upside down, and outside out again
    EXPECT_FALSE(behind.empty());
    for (const FrontPatch& patch : behind) {
        EXPECT_EQ(cornersAcross(patch, frame), 4);
        EXPECT_FALSE(patch.folded);
    }
}

TEST(Front, IsIndependentOfThePoolAndEmptyWhereNoLightIsLeft) {
    const Fields fields = test::clearSphere(24);
    const Scene scene = test::sceneWith(PointLight{{-1.5, 0.2, 0.1}, glm::dvec3(1.0)});
    const auto all = fronts(scene, fields, {0.7, 1.9});
    const auto few = fronts(scene, fields, {0.7, 1.9}, {.poolPatches = 256});
    ASSERT_EQ(all.size(), few.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i].corners, few[i].corners);
        EXPECT_EQ(all[i].irradiance, few[i].irradiance);
        EXPECT_EQ(all[i].folded, few[i].folded);
    }
    EXPECT_TRUE(fronts(scene, fields, {1e6}).empty());
    EXPECT_TRUE(fronts(Scene{}, fields, {1.0}).empty());
}

} // namespace
} // namespace eikonal
