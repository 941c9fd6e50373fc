// Ends of the ranges: fixed point, single precision, extinction, phase functions, bands.
#include <cmath>

#include "common/error.h"
#include "lightsim/emit.h"
#include "lightsim/settings.h"
#include "shaders/shared/bake_blocks.h"
#include "tests/stability/hard_cases.h"

namespace eikonal {
namespace {

using test::bakedCase;
using test::kBallInSmoke;

TEST(StableRanges, AccumulatorsHoldTheWorstFocus) {
    // All the light of a beam through one voxel, for as long as light is followed at all: 2^60 units of the sums, or less.
    const test::HardCase hard = bakedCase(kBallInSmoke, {"object.0.ior=4"});
    const bake::Criteria criteria = bake::criteriaOf(hard.scene.accuracy, hard.fields);
    const bake::LaunchGrids grids =
        bake::launchGrids({hard.scene.lights, {}}, hard.fields.lattice, criteria);
    const bake::BakeSettings settings = bake::settingsOf(criteria, grids, hard.fields, {});
    const double longestVoxels = settings.maxSteps * criteria.opticalStep / hard.fields.lattice.voxel;
    EXPECT_LE(double(settings.depositScale) * grids.strongestPower * longestVoxels, std::exp2(60.0) * (1.0 + 1e-6));
    EXPECT_LE(double(settings.ledgerScale) * grids.strongestPower, std::exp2(60.0) * (1.0 + 1e-6));
    test::expectSound(hard);
}

TEST(StableRanges, ExtinctionFromNothingToEverything) {
    // in thin smoke light counts in full wherever it goes; what the ball's edge reflects few rays know on 16 voxels, to 4 %
    test::expectSoundScene(kBallInSmoke, {"medium.scattering=1e-12", "object.0.scattering=1e-12"}, 0.05);
    test::expectSoundScene(kBallInSmoke, {"object.0.absorption=1e-12"});
    // light falls by a third in a voxel: the grid's mean of the product is good to 4 %
    test::expectSoundScene(kBallInSmoke, {"medium.scattering=3", "object.0.scattering=3"}, 0.05);
}

TEST(StableRanges, ThinSmokeScattersInProportion) {
    const auto scattered = [](const std::string& sigma, const std::string& deposit) {
        const test::HardCase hard = bakedCase(kBallInSmoke, {"medium.scattering=" + sigma, "object.0.scattering=" + sigma,
                                                             "accuracy.deposit='" + deposit + "'"});
        return hard.bake.statistics.energy.scattered.x;
    };
    for (const char* deposit : {"cells", "splat"}) {
        // of 1e-4 a unit light loses up to 2e-4 on its way; ten thousand rays' shares are rounded to a hundredth each
        EXPECT_NEAR(scattered("1e-12", deposit) / scattered("1e-4", deposit), 1e-8, 1e-3 * 1e-8) << deposit;
    }
}

TEST(StableRanges, MatterAsGoodAsOpaque) {
    // An optical depth of 1e5 in a voxel: the ledger is right, the picture finite, and no voxel brighter than the beam. The
    // grid holds the mean of the light at both ends of a step, not the thin skin's, so ledger and grid do not agree.
    for (const char* term : {"medium.scattering=1e6", "medium.absorption=1e6", "object.0.absorption=1e6"}) {
        SCOPED_TRACE(term);
        const test::HardCase hard = bakedCase(kBallInSmoke, {term});
        EXPECT_LE(std::abs(hard.bake.statistics.energy.balance().x), test::kLedgerRounding);
        for (const glm::vec3& irradiance : hard.bake.light.irradiance.values) ASSERT_LE(irradiance.x, 60.0f);
        test::expectSound(test::renderedCase(hard));
    }
}

TEST(StableRanges, ScatteringAllForwardsOrBackwards) {
    for (const char* g : {"0.999", "-0.999"}) {
        test::expectSoundScene(kBallInSmoke, {std::string("medium.anisotropy=") + g});
    }
}

TEST(StableRanges, LobesOfAPhaseFunctionLikeANeedle) {
    const test::HardCase hard = bakedCase(kBallInSmoke, {"medium.anisotropy=0.999", "accuracy.directional='lobes'"});
    test::expectSound(hard);
    test::expectSound(test::renderedCase(hard));
}

TEST(StableRanges, ThirtyTwoBands) {
    const test::HardCase hard =
        bakedCase(kBallInSmoke, {"object.0.cauchy_b=0.01", "accuracy.bands=32", "domain.resolution=8"});
    ASSERT_EQ(hard.bake.statistics.bands.size(), 32u);
    for (const BandLedger& band : hard.bake.statistics.bands) {
        EXPECT_LE(std::abs(band.energy.balance().x), test::kLedgerRounding) << band.wavelengthNm << " nm";
    }
    test::expectSound(test::renderedCase(hard));
}

TEST(StableRanges, NumbersBeyondSinglePrecisionAreRefused) {
    for (const char* term : {"medium.scattering=1e39", "object.0.emission=1e39", "object.0.ior=1e39", "object.0.ior=1e-39",
                             "light.0.irradiance=[1e39, 1, 1]", "environment.intensity=1e39", "camera.position=[0, 0, 1e39]",
                             "medium.absorption='1e39*x*x'", "object.0.ior='1/(r - 0.1)^30'"}) {
        try {
            test::bakedCase(kBallInSmoke, {term});
            ADD_FAILURE() << term << " was taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::kBadInput) << term;
            EXPECT_NE(std::string(error.what()).find("expected"), std::string::npos) << error.what();
        }
    }
}

} // namespace
} // namespace eikonal
