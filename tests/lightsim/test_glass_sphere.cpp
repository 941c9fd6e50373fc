// A parallel beam on a smoothed glass sphere against brute force in double precision on the closed form of its index.
#include "common/reference/bake_reference.h"
#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

std::size_t brightest(const DenseGrid<glm::dvec3>& grid) {
    return std::size_t(std::max_element(grid.values.begin(), grid.values.end(),
                                        [](const auto& a, const auto& b) { return a.x < b.x; }) -
                       grid.values.begin());
}

glm::ivec3 indexOf(std::size_t offset, const glm::ivec3& size) {
    const int i = int(offset);
    return {i % size.x, i / size.x % size.y, i / (size.x * size.y)};
}

DenseGrid<glm::dvec3> inDouble(const DenseGrid<glm::vec3>& grid) {
    DenseGrid<glm::dvec3> result(grid.size, glm::dvec3(0.0));
    std::copy(grid.values.begin(), grid.values.end(), result.values.begin());
    return result;
}

double sumOf(const DenseGrid<glm::dvec3>& grid) {
    double sum = 0.0;
    for (const glm::dvec3& value : grid.values) {
        sum += value.x;
    }
    return sum;
}

TEST(GlassSphere, MatchesBruteForce) {
    const Lattice lattice = test::cube(64, 1.0);
    const double width = 1.5 * lattice.voxel;
    const BakeResult result =
        test::bake(test::sceneWith(DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0)}), test::clearSphere(64));
    const auto truth = reference::bakeSymmetricBeam(reference::SmoothedSphere(0.6, 1.5, width), lattice, {});
    const DenseGrid<glm::dvec3> irradiance = inDouble(result.light.irradiance);

    EXPECT_LE(test::relativeL1(result.light.irradiance, truth), 0.04);  // the promise at default accuracy
    EXPECT_NEAR(sumOf(irradiance) / sumOf(truth), 1.0, 0.005);          // likewise
    const glm::ivec3 apart = glm::abs(indexOf(brightest(irradiance), lattice.size) - indexOf(brightest(truth), lattice.size));
    EXPECT_LE(std::max({apart.x, apart.y, apart.z}), 1);
    // nearer than the paraxial focus, n R / (2 (n - 1)) from the centre: spherical aberration
    const double paraxialFocus = 1.5 * 0.6 / (2.0 * 0.5);
    EXPECT_LT(lattice.worldFromIndex(indexOf(brightest(irradiance), lattice.size)).x, paraxialFocus);
    EXPECT_GT(result.statistics.patches.folds, 0u);  // patches behind the focus are turned inside out, and live
}

TEST(GlassSphere, MatchesBruteForceInterpolatedLinearlyToo) {
    const Fields fields = test::clearSphere(64);
    Scene scene = test::sceneWith(DirectionalLight{{1.0, 0.0, 0.0}, glm::dvec3(1.0)});
    scene.accuracy.interpolation = Interpolation::kLinear;
    const BakeResult result = test::bake(scene, fields);
    const double width = 1.5 * fields.lattice.voxel;
    const auto truth = reference::bakeSymmetricBeam(reference::SmoothedSphere(0.6, 1.5, width), fields.lattice, {});
    EXPECT_LE(test::relativeL1(result.light.irradiance, truth), 0.04);  // the promises at default accuracy
    EXPECT_NEAR(sumOf(inDouble(result.light.irradiance)) / sumOf(truth), 1.0, 0.005);
}

} // namespace
} // namespace eikonal
