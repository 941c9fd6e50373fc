// A point light in Maxwell's fish-eye n = n0/(1 + r²/a²). Its rays are the geodesics of a sphere of radius n0 a/2 under
// stereographic projection, so that wavefronts are circles there, of area 4π (n0 a/2)² sin²ψ at the angle ψ from the light,
// and n² times less in the medium.
#include <numbers>

#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

constexpr double kIndex = 2.0;  // n0, with a = 1

double indexAt(const glm::dvec3& x) { return kIndex / (1.0 + glm::dot(x, x)); }

/// sin² ψ between two points on the sphere; s is sin²(ψ/2), the square of half the chord.
double sineSquaredBetween(const glm::dvec3& x, const glm::dvec3& y) {
    const glm::dvec3 offset = x - y;
    const double s = glm::dot(offset, offset) / ((1.0 + glm::dot(x, x)) * (1.0 + glm::dot(y, y)));
    return 4.0 * s * (1.0 - s);
}

double fishEyeIrradiance(const PointLight& light, const glm::dvec3& x) {
    const double n = indexAt(x), radius = 0.5 * kIndex;
    return light.power.x * n * n /
           (4.0 * std::numbers::pi * radius * radius * sineSquaredBetween(light.position, x));
}

/// Not near the light and its image, where irradiance has no bound. The unit ball is half of the sphere: geodesics between
/// its points stay in it, and in the domain.
bool isCompared(const PointLight& light, const glm::dvec3& x) {
    const glm::dvec3 image = -light.position / glm::dot(light.position, light.position);
    return glm::length(x) < 0.8 && glm::distance(x, light.position) > 0.3 && glm::distance(x, image) > 0.3;
}

class FishEye : public ::testing::TestWithParam<glm::dvec3> {};

TEST_P(FishEye, HasTheIrradianceOfASphere) {
    const PointLight light{GetParam(), glm::dvec3(10.0)};
    const BakeResult result = test::bake(test::sceneWith(light), test::indexFields(test::cube(64, 1.0), indexAt));
    const test::RelativeErrors errors =
        test::errorsAgainst(result.light, [&](const glm::dvec3& x) { return isCompared(light, x); },
                            [&](const glm::dvec3& x) { return fishEyeIrradiance(light, x); });
    EXPECT_GT(errors.voxels, 60000);
    EXPECT_LE(errors.rms, 0.01);              // the promise at default accuracy
    EXPECT_LE(std::abs(errors.bias), 0.001);  // as of a point light in vacuum
}

// inside, and at the surface r = a, whose image is the other end of the diameter
INSTANTIATE_TEST_SUITE_P(Lights, FishEye, ::testing::Values(glm::dvec3(0.45, 0.1, -0.05), glm::dvec3(0.017, -0.985, 0.023)));

} // namespace
} // namespace eikonal
