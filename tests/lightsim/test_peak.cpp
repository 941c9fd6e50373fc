// The method of 2007, which keeps the largest irradiance of a voxel: right where one smooth front passes, without a bound
// where light gathers, and dark behind a focus.
#include <numbers>

#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

Scene withPeaks(Scene scene) {
    scene.accuracy.deposit = Deposit::kPeak;
    return scene;
}

/// Of the band 0.
double meanIrradiance(const BakeResult& result) {
    double sum = 0.0;
    for (const glm::vec3& irradiance : result.light.irradiance.values) {
        sum += irradiance.x;
    }
    return sum / double(result.light.irradiance.values.size());
}

const Scene kBeam = test::sceneWith(DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0)});

TEST(Peak, OfAPointLightIsTheIrradianceOfAVoxelsNearSide) {
    const PointLight light{{0.013, -0.021, 0.017}, glm::dvec3(10.0)};
    const BakeResult result = test::bake(withPeaks(test::sceneWith(light)), test::uniformFields(test::cube(64, 1.0)));
    const Lattice& lattice = result.light.lattice;
    double squares = 0.0;
    int count = 0;
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        const glm::dvec3 offset = lattice.worldFromIndex(v) - light.position;
        const double r = glm::length(offset);
        if (r < 0.3 || r > 0.9) {
            return;
        }
        const double ratio = result.light.irradiance.at(v).x * 4.0 * std::numbers::pi * r * r / light.power.x;
        const glm::dvec3 nearest = glm::max(glm::abs(offset) - 0.5 * lattice.voxel, 0.0);
        EXPECT_LT(ratio, 1.005 * r * r / glm::dot(nearest, nearest));  // flat patches: short of a sphere's area by 0.1 %
        EXPECT_GT(ratio, 0.97);  // every voxel has a point within half its edge of the middle
        squares += (ratio - 1.0) * (ratio - 1.0);
        // the middle of the patch is at most 0.87 + 0.71 voxels from the voxel's: 9 degrees where it is nearest
        EXPECT_GT(glm::dot(glm::dvec3(result.light.lightDirection.at(v)), offset / r), 0.987);
        ++count;
    });
    // nearer than the middle by 0.75 h/2 on the average over directions, twice that in 1/r²: 7 % at the mean distance;
    // points half a voxel apart fall short of the nearest place
    EXPECT_LT(std::sqrt(squares / count), 0.065);
}

TEST(Peak, OverstatesTheEnergyBehindAGlassSphere) {
    const Fields fields = test::clearSphere(64);
    const BakeResult peak = test::bake(withPeaks(kBeam), fields);
    const BakeResult splat = test::bake(kBeam, fields);
    // the splat is right within 0.5 % (GlassSphere.MatchesBruteForce); the trial that chose it found 3.06 times the energy
    // for peaks in double precision, and what is found depends on how closely a patch happens to meet the focus
    EXPECT_GT(meanIrradiance(peak), 3.0 * meanIrradiance(splat));
}

TEST(Peak, EndsPatchesThatFoldAndBooksTheirPower) {
    const Fields fields = test::clearSphere(32);
    const BakeResult peak = test::bake(withPeaks(kBeam), fields);
    const EnergyLedger& energy = peak.statistics.energy;
    EXPECT_GT(peak.statistics.patches.folds, 0u);
    EXPECT_NEAR(energy.balance().x, 0.0, 1e-5);  // fixed point and single precision, as without folds
    // what meets the sphere crosses its axis within the domain; beyond 3 widths of the boundary nothing is bent
    const double area = std::numbers::pi * 0.6 * 0.6;
    const double widest = 0.6 + 3.0 * 1.5 * fields.lattice.voxel;
    EXPECT_GT(energy.culled.x, area);
    EXPECT_LT(energy.culled.x, std::numbers::pi * widest * widest);
}

} // namespace
} // namespace eikonal
