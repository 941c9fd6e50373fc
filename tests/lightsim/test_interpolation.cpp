// How light finds the index between voxels, where a scene leaves that to the program.
#include <cmath>

#include "common/reference/bake_reference.h"
#include "lightsim/settings.h"
#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

Scene beam(Interpolation interpolation, Deposit deposit = Deposit::kAuto) {
    Scene scene = test::sceneWith(DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0)});
    scene.accuracy.interpolation = interpolation;
    scene.accuracy.deposit = deposit;
    return scene;
}

/// Luneburg's lens, whose gradient ends at its surface.
Fields kinkedLens(int resolution) {
    return test::indexFields(test::cube(resolution, 1.125), [](const glm::dvec3& x) {
        const double r2 = glm::dot(x, x);
        return r2 < 1.0 ? std::sqrt(2.0 - r2) : 1.0;
    });
}

void expectAutoIs(Interpolation interpolation, const Fields& fields, Deposit deposit = Deposit::kAuto) {
    const BakeResult found = test::bake(beam(Interpolation::kAuto, deposit), fields);
    EXPECT_EQ(found.statistics.interpolation, interpolation);
    EXPECT_EQ(found.light.irradiance.values, test::bake(beam(interpolation, deposit), fields).light.irradiance.values);
}

TEST(InterpolationOfLight, IsCubicWhereBoundariesAreSmooth) { expectAutoIs(Interpolation::kCubic, test::clearSphere(24)); }

TEST(InterpolationOfLight, IsLinearWhereGradientsJump) { expectAutoIs(Interpolation::kLinear, kinkedLens(24)); }

TEST(InterpolationOfLight, IsLinearForPatches) {
    expectAutoIs(Interpolation::kLinear, test::clearSphere(24), Deposit::kSplat);
    expectAutoIs(Interpolation::kLinear, test::clearSphere(24), Deposit::kPeak);
}

TEST(InterpolationOfLight, IsTheSameOnCoarseAndOnFineVoxels) {
    for (const int resolution : {16, 24, 48}) {
        EXPECT_EQ(bake::interpolationOfLight({}, test::clearSphere(resolution).ior), Interpolation::kCubic) << resolution;
        EXPECT_EQ(bake::interpolationOfLight({}, kinkedLens(resolution).ior), Interpolation::kLinear) << resolution;
    }
}

TEST(InterpolationOfLight, IsWhatTheSceneSays) {
    const Accuracy linear{.interpolation = Interpolation::kLinear}, cubic{.interpolation = Interpolation::kCubic};
    EXPECT_EQ(bake::interpolationOfLight(linear, test::clearSphere(16).ior), Interpolation::kLinear);
    EXPECT_EQ(bake::interpolationOfLight(cubic, kinkedLens(16).ior), Interpolation::kCubic);
}

/// The error of a bake against the closed form of the index.
double errorOfSphere(Interpolation interpolation) {
    const Fields fields = test::clearSphere(64);
    Scene scene = beam(interpolation);
    scene.accuracy.tolerance = 0.01;
    const double width = 1.5 * fields.lattice.voxel;
    const auto truth = reference::bakeSymmetricBeam(reference::SmoothedSphere(0.6, 1.5, width), fields.lattice, {});
    return test::relativeL1(test::bake(scene, fields).light.irradiance, truth);
}

TEST(InterpolationOfLight, ThroughCubicsErrsByLessOnASmoothedSphere) {
    EXPECT_LT(errorOfSphere(Interpolation::kCubic), 0.7 * errorOfSphere(Interpolation::kLinear));
}

} // namespace
} // namespace eikonal
