// Lights where none belongs: in glass, on boundaries and faces, very far, very weak, very strong, two in one place.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/stability/hard_cases.h"

namespace eikonal {
namespace {

using test::bakedCase;
using test::expectSound;
using test::kBallInSmoke;

std::string pointAt(const std::string& position) { return kBallInSmoke + "type = 'point'\nposition = " + position + "\n"; }

double enteredShare(const test::HardCase& hard) {
    return hard.bake.statistics.energy.entered.x / hard.bake.statistics.energy.emitted.x;
}

TEST(StableLights, WhereverALampIsInTheDomainAllItsPowerEnters) {
    // a voxel's centre, glass, the middle of a voxel's edge, the boundary of the glass
    for (const char* position : {"[0.0625, 0.0625, 0.0625]", "[0.1, 0.2, 0.05]", "[0, 0, 0]", "[0.5, 0, 0]"}) {
        SCOPED_TRACE(position);
        const test::HardCase hard = bakedCase(pointAt(position));
        expectSound(hard);
        expectSound(test::renderedCase(hard));
        EXPECT_NEAR(enteredShare(hard), 1.0, 1e-6);
    }
}

TEST(StableLights, OnAFaceOrACornerPartOfThePowerEnters) {
    // A half of the sphere of directions, an eighth. Rays in the face count as entering, and stand for 1/64 of an edge of the
    // launch cube on its other side: 2.8 % more around the half space, 8.6 % around the octant.
    EXPECT_NEAR(enteredShare(bakedCase(pointAt("[1, 0.3, 0.2]"))), 0.5, 0.03 * 0.5);
    EXPECT_NEAR(enteredShare(bakedCase(pointAt("[1, 1, 1]"))), 0.125, 0.09 * 0.125);
}

TEST(StableLights, JustOutsideAFace) {
    // the solid angle of a face of edge 2 seen from 1e-3 above (0.3, 0.2): a half less what passes beside it
    const auto corner = [](double a, double b, double d) { return std::atan(a * b / (d * std::sqrt(a * a + b * b + d * d))); };
    const double d = 1e-3;
    const double solidAngle = corner(0.7, 0.8, d) + corner(1.3, 0.8, d) + corner(0.7, 1.2, d) + corner(1.3, 1.2, d);
    const test::HardCase hard = bakedCase(pointAt("[1.001, 0.3, 0.2]"));
    expectSound(hard);
    EXPECT_NEAR(enteredShare(hard), solidAngle / (4.0 * std::numbers::pi), 0.01);
}

TEST(StableLights, AMillionUnitsAwayItIsABeam) {
    const double distance = 1e6, power = 4.0 * std::numbers::pi * distance * distance;
    const test::HardCase far = bakedCase(pointAt("[-1e6, 0, 0]"), {"light.0.power=" + std::string("[") + std::to_string(power) +
                                                                   "," + std::to_string(power) + "," + std::to_string(power) + "]"});
    const test::HardCase beam = bakedCase(kBallInSmoke);
    expectSound(far);
    double difference = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < far.bake.light.irradiance.values.size(); ++i) {
        difference += std::abs(double(far.bake.light.irradiance.values[i].x) - double(beam.bake.light.irradiance.values[i].x));
        sum += beam.bake.light.irradiance.values[i].x;
    }
    // both are cut into launch cells at other places: what is off is the deposit's own error at this resolution
    EXPECT_LE(difference / sum, 0.02);
}

TEST(StableLights, PowerScalesToTheBit) {
    const BakedLight one = bakedCase(pointAt("[0, 0.9, 0]"), {"light.0.power=[1, 1, 1]"}).bake.light;
    for (const double power : {std::exp2(-100.0), std::exp2(49.0)}) {
        const std::string text = std::to_string(power);
        Scene scene = bakedCase(pointAt("[0, 0.9, 0]")).scene;
        std::get<PointLight>(scene.lights[0]).power = glm::dvec3(power);
        const Fields fields = composeFields(scene);
        const BakeResult scaled = bakeScene(test::sharedContext(), scene, fields, decideEffects(scene, fields), {});
        for (std::size_t i = 0; i < one.irradiance.values.size(); ++i) {
            ASSERT_EQ(scaled.light.irradiance.values[i], one.irradiance.values[i] * float(power)) << "voxel " << i;
        }
        EXPECT_LE(std::abs(scaled.statistics.energy.balance().x), test::kLedgerRounding);
    }
}

TEST(StableLights, NoPowerIsDarkness) {
    const test::HardCase dark = bakedCase(pointAt("[0, 0.9, 0]"), {"light.0.power=[0, 0, 0]"});
    expectSound(dark);
    EXPECT_EQ(dark.bake.statistics.energy.entered, glm::dvec3(0.0));
}

TEST(StableLights, TwoInOnePlaceAreOneOfTwiceThePower) {
    const std::string lamp = "type = 'point'\nposition = [0, 0.9, 0]\n";
    const BakedLight one = bakedCase(kBallInSmoke + lamp).bake.light;
    const test::HardCase two = bakedCase(kBallInSmoke + lamp + "[[light]]\n" + lamp);
    expectSound(two);
    for (std::size_t i = 0; i < one.irradiance.values.size(); ++i) {
        // each deposit rounds to units of the sums, of which a voxel's mean light holds 2^25 and more
        ASSERT_NEAR(two.bake.light.irradiance.values[i].x, 2.0f * one.irradiance.values[i].x,
                    1e-4f * (1.0f + one.irradiance.values[i].x));
    }
}

TEST(StableLights, AlongAnAxisAndAlmost) {
    const BakedLight along = bakedCase(kBallInSmoke).bake.light;
    const test::HardCase almost = bakedCase(kBallInSmoke, {"light.0.direction=[1, 1e-7, -1e-7]"});
    expectSound(almost);
    double difference = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < along.irradiance.values.size(); ++i) {
        difference += std::abs(double(along.irradiance.values[i].x) - double(almost.bake.light.irradiance.values[i].x));
        sum += along.irradiance.values[i].x;
    }
    EXPECT_LE(difference / sum, 1e-4);  // a ray is 2e-7 off at the far face; single precision is 1e-7 of the domain
}

} // namespace
} // namespace eikonal
