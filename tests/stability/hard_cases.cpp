#include "tests/stability/hard_cases.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "common/scene_toml.h"

namespace eikonal::test {

namespace {

const std::string kBall = R"(
[[object]]
radius = 0.5
ior = 1.5
scattering = 0.3
[[light]]
)";

/// What a voxel may hold over what all the light leaves in one crossing along an edge: a ray in a focus or against a mirror
/// crosses it twice, along its diagonal at the most.
constexpr double kMostCrossings = 2.0 * 1.7321;
// Directions are quotients of two fixed-point sums.
constexpr double kUnitLength = 1.0 + 1e-5;

double strongest(const glm::dvec3& v) { return std::max({v.r, v.g, v.b}); }

/// Keeps the largest value of a test in its report (--gtest_output=xml): what docs/stability.md calls measured.
void record(const std::string& name, double value) {
    static std::map<std::string, double> worst;
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    double& known = worst[std::string(test.test_suite_name()) + test.name() + name];
    known = std::max(known, value);
    std::ostringstream text;
    text << known;
    testing::Test::RecordProperty(name, text.str());
}

void expectSoundVoxels(const HardCase& hard) {
    const BakedLight& light = hard.bake.light;
    const double most = kMostCrossings * strongest(hard.bake.statistics.energy.entered) /
                        (light.lattice.voxel * light.lattice.voxel);
    std::size_t bad = 0;
    for (std::size_t voxel = 0; voxel < light.irradiance.values.size(); ++voxel) {
        const glm::dvec3 irradiance(light.irradiance.values[voxel]), direction(light.lightDirection.values[voxel]);
        const bool sound = irradiance.r >= 0.0 && irradiance.g >= 0.0 && irradiance.b >= 0.0 &&
                           strongest(irradiance) <= most && glm::length(direction) <= kUnitLength;  // false for NaN
        bad += sound ? 0 : 1;
    }
    EXPECT_EQ(bad, 0u) << "of " << light.irradiance.values.size() << " voxels";
}

} // namespace

const std::string kSmoke = "[domain]\nresolution = 16\n[medium]\nscattering = 0.3\n[render]\nsize = [24, 18]\ntone_map = 'none'\n";
const std::string kBallInSmoke = kSmoke + kBall;

std::string fieldInSmoke(const std::string& ior, double half) {
    const std::string edge = std::to_string(2.0 * half);
    return kSmoke + "[[object]]\nshape = 'field'\nsize = [" + edge + ", " + edge + ", " + edge + "]\nior = \"" + ior +
           "\"\nscattering = 0.3\n";
}

HardCase bakedCase(const std::string& toml, const std::vector<std::string>& overrides) {
    HardCase hard;
    hard.scene = parseScene(toml, "hard.toml", ".", overrides);
    hard.fields = composeFields(hard.scene);
    hard.bake = bakeScene(sharedContext(), hard.scene, hard.fields, decideEffects(hard.scene, hard.fields), {});
    return hard;
}

RenderResult renderedCase(const HardCase& hard) {
    return renderScene(sharedContext(), hard.scene, hard.fields, decideEffects(hard.scene, hard.fields), &hard.bake.light);
}

void expectSound(const HardCase& hard, double gridShare) {
    expectSoundVoxels(hard);
    const EnergyLedger& energy = hard.bake.statistics.energy;
    for (int band = 0; band < 3; ++band) {
        const double ledger = std::abs(energy.balance()[band]);
        const double grid = std::abs(energy.depositedScattered[band] - energy.scattered[band]);
        EXPECT_LE(ledger, kLedgerRounding) << "band " << band;
        EXPECT_LE(grid, gridShare * energy.scattered[band])
            << "band " << band << ": grid " << energy.depositedScattered[band] << ", ledger " << energy.scattered[band];
        record("ledger", ledger);
        record("grid", energy.scattered[band] > 0.0 ? grid / energy.scattered[band] : 0.0);
    }
}

void expectSound(const RenderResult& picture) {
    constexpr float kLimit = 4095.0f;  // of evaluations, at these sizes
    for (const RenderChannel& channel : picture.channels) {
        const bool infiniteWhereMissed = channel.name == "Z";
        const bool isColor = channel.name.size() == 1 && !infiniteWhereMissed;
        const auto isBad = [&](float value) {
            return !(std::isfinite(value) || infiniteWhereMissed) || (isColor && value < 0.0f) ||
                   (channel.name == "steps" && value >= kLimit);
        };
        EXPECT_EQ(std::count_if(channel.values.begin(), channel.values.end(), isBad), 0) << channel.name;
    }
}

void expectSoundScene(const std::string& toml, const std::vector<std::string>& overrides, double gridShare) {
    std::string name;
    for (const std::string& entry : overrides) name += entry + " ";
    SCOPED_TRACE(name);
    const HardCase hard = bakedCase(toml, overrides);
    expectSound(hard, gridShare);
    expectSound(renderedCase(hard));
}

} // namespace eikonal::test
