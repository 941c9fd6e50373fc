// A fold caustic: a beam enters a layer in which n² falls linearly with z. Its rays are parabolas that all turn at the same
// height, where n is the tangential wave vector k: with d the distance below it, the rising and the falling sheet together
// have E = 2 E₀ cos θ₀ n/√(g d), where −g is the slope of n².
#include <numbers>

#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

constexpr double kVoxel = 1.0 / 48.0;
constexpr double kIndexBelow = 1.5;  // at the face z = 0 where the beam enters
constexpr double kAngle = std::numbers::pi / 3.0;
constexpr double kTurningHeight = 24.0 * kVoxel;

struct Layer {
    double k = kIndexBelow * std::sin(kAngle);
    double slope = (kIndexBelow * kIndexBelow - k * k) / kTurningHeight;  // g

    double index(double z) const { return std::sqrt(kIndexBelow * kIndexBelow - slope * z); }
    /// Along x from where a ray enters through z = 0 to where it leaves through it.
    double range() const { return 4.0 * k * kIndexBelow * std::cos(kAngle) / slope; }
};

/// Long enough for a stretch that no light reaches from its first end, where rays enter that turn lower.
Lattice layerLattice(const Layer& layer) {
    return {glm::dvec3(0.0), kVoxel, {int(1.3 * layer.range() / kVoxel), 8, 28}};
}

/// Mean irradiance of a layer of voxels `below` voxels under the caustic, in the stretch behind the range.
double irradianceBelow(const BakedLight& light, const Layer& layer, int below) {
    const int first = int(1.02 * layer.range() / kVoxel), last = light.lattice.size.x - 4;
    const int k = int(kTurningHeight / kVoxel) - 1 - below;
    double sum = 0.0;
    for (int i = first; i < last; ++i) {
        sum += light.irradiance.at(i, light.lattice.size.y / 2, k).x;
    }
    return sum / (last - first);
}

/// Slope of a least-squares line through points.
double slopeOf(const std::vector<glm::dvec2>& points) {
    glm::dvec2 mean(0.0);
    for (const glm::dvec2& p : points) mean += p / double(points.size());
    double xx = 0.0, xy = 0.0;
    for (const glm::dvec2& p : points) {
        xx += (p.x - mean.x) * (p.x - mean.x);
        xy += (p.x - mean.x) * (p.y - mean.y);
    }
    return xy / xx;
}

TEST(Fold, FallsWithTheRootOfTheDistance) {
    const Layer layer;
    const Fields fields =
        test::indexFields(layerLattice(layer), [&](const glm::dvec3& x) { return layer.index(x.z); });
    const DirectionalLight beam{{std::sin(kAngle), 0.0, std::cos(kAngle)}, glm::dvec3(1.0)};
    const BakeResult result = test::bake(test::sceneWith(beam), fields);
    std::vector<glm::dvec2> points;
    for (int below = 3; below <= 20; ++below) {
        const double d = (below + 0.5) * kVoxel, n = layer.index(kTurningHeight - d);
        const double irradiance = irradianceBelow(result.light, layer, below);
        const double truth = 2.0 * std::cos(kAngle) * n / std::sqrt(layer.slope * d);
        points.emplace_back(std::log(d), std::log(irradiance / n));
        EXPECT_NEAR(irradiance, truth, 0.01 * truth) << below;  // what is asked of smooth fronts
    }
    EXPECT_NEAR(slopeOf(points), -0.5, 0.05);  // the promise
    EXPECT_EQ(irradianceBelow(result.light, layer, -2), 0.0) << "beyond the caustic is shadow";
}

} // namespace
} // namespace eikonal
