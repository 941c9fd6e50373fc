// Domains anywhere, of any size and shape: results scale and do not drift.
#include <cmath>

#include "tests/stability/hard_cases.h"

namespace eikonal {
namespace {

using test::HardCase;

/// The ball in smoke, moved and scaled as a whole: what is seen and baked should be the same.
HardCase placed(double scale, double offset) {
    HardCase hard;
    hard.scene = test::bakedCase(test::kBallInSmoke).scene;
    Scene& scene = hard.scene;
    scene.domain.min = glm::dvec3(offset - scale);
    scene.domain.max = glm::dvec3(offset + scale);
    scene.medium.scattering.constant /= scale;
    Object& ball = scene.objects[0];
    std::get<SphereShape>(ball.shape).radius *= scale;
    ball.scattering.constant /= scale;
    ball.translate = glm::dvec3(offset);
    scene.camera.position = scale * glm::dvec3(0.3, 0.4, 4.0) + offset;
    scene.camera.lookAt = glm::dvec3(offset);
    hard.fields = composeFields(scene);
    hard.bake = bakeScene(test::sharedContext(), scene, hard.fields, decideEffects(scene, hard.fields), {});
    return hard;
}

/// Largest difference of two grids over the largest value.
double difference(const DenseGrid<glm::vec3>& a, const DenseGrid<glm::vec3>& b) {
    double largest = 0.0, most = 0.0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        largest = std::max(largest, double(std::abs(a.values[i].x - b.values[i].x)));
        most = std::max(most, double(b.values[i].x));
    }
    return largest / most;
}

double pictureDifference(const RenderResult& a, const RenderResult& b) {
    double largest = 0.0;
    for (int y = 0; y < a.size.y; ++y) {
        for (int x = 0; x < a.size.x; ++x) {
            const glm::vec3 off = glm::abs(a.radiance(x, y) - b.radiance(x, y));
            largest = std::max(largest, double(std::max({off.r, off.g, off.b})));
        }
    }
    return largest;
}

TEST(StableDomains, ResultsScaleAndDoNotDrift) {
    const HardCase plain = placed(1.0, 0.0);
    test::expectSound(plain);
    const RenderResult picture = test::renderedCase(plain);
    const struct { double scale, offset, tolerance; } kPlaces[] = {
        // A power of two changes no bit. Other scales round coordinates to 6e-8 of the domain, an offset of 1e5 to 1e-11: then a
        // patch at a threshold may be halved or not, within half the tolerance of a bake, 0.02.
        {std::exp2(20.0), 0.0, 0.0}, {std::exp2(-20.0), 0.0, 0.0}, {1e6, 0.0, 0.01}, {1e-6, 0.0, 0.01}, {1.0, 1e5, 0.01}};
    for (const auto& [scale, offset, tolerance] : kPlaces) {
        SCOPED_TRACE(testing::Message() << "scale " << scale << ", offset " << offset);
        const HardCase moved = placed(scale, offset);
        EXPECT_LE(difference(moved.bake.light.irradiance, plain.bake.light.irradiance), tolerance);
        EXPECT_LE(pictureDifference(test::renderedCase(moved), picture), tolerance);
        const double entered = moved.bake.statistics.energy.entered.x / (scale * scale);
        EXPECT_NEAR(entered, plain.bake.statistics.energy.entered.x, 1e-5 * entered);
    }
}

TEST(StableDomains, ThatAreNoCubes) {
    test::expectSoundScene(test::kBallInSmoke, {"domain.min=[-1, -0.3, -0.6]", "domain.max=[1, 0.25, 0.61]"});
    test::expectSoundScene(test::kBallInSmoke, {"domain.min=[-0.02, -1, -1]", "domain.max=[0.02, 1, 1]"});
    test::expectSoundScene(test::kBallInSmoke, {"domain.min=[-1, -0.02, -0.02]", "domain.max=[1, 0.02, 0.02]"}, 0.03);
}

TEST(StableDomains, OfOneTwoThreeAndOddNumbersOfVoxels) {
    for (const char* resolution : {"1", "2", "3", "5", "7", "17"}) {
        // few voxels sample the light that few launch cells carry at few points
        test::expectSoundScene(test::kBallInSmoke, {std::string("domain.resolution=") + resolution}, 0.08);
    }
}

} // namespace
} // namespace eikonal
