// Rectangle lights against the closed forms of a Lambertian rectangle.
#include <numbers>

#include "lightsim/point_source.h"
#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

/// In the middle of the domain, shining along +z.
RectangleLight panel() {
    RectangleLight light;
    light.position = {0.0, 0.0, -0.6};
    light.direction = {0.0, 0.0, 1.0};
    light.size = {0.8, 0.4};
    light.power = glm::dvec3(10.0);
    light.samples = 32;
    return light;
}

double radianceOf(const RectangleLight& light) {
    return light.power.x / (std::numbers::pi * light.size.x * light.size.y);
}

/// The integral of a function over the rectangle as seen from a point, from that over a rectangle with one corner at the
/// foot of the point: (width, height, distance), odd in the first two.
template <class Quadrant>
double overRectangle(const RectangleLight& light, const glm::dvec3& point, const Quadrant& quadrant) {
    const glm::dvec3 p = point - light.position;
    const glm::dvec2 low = -0.5 * light.size - glm::dvec2(p), high = 0.5 * light.size - glm::dvec2(p);
    return quadrant(high.x, high.y, p.z) - quadrant(low.x, high.y, p.z) - quadrant(high.x, low.y, p.z) +
           quadrant(low.x, low.y, p.z);
}

/// [sr]
double quadrantSolidAngle(double x, double y, double d) { return std::atan(x * y / (d * std::sqrt(x * x + y * y + d * d))); }

/// Form factor to a small parallel area times π.
double quadrantProjectedSolidAngle(double x, double y, double d) {
    const double u = std::hypot(x, d), v = std::hypot(y, d);
    return 0.5 * (x / u * std::atan(y / u) + y / v * std::atan(x / v));
}

/// Relative errors over voxels: their root mean square and their mean.
struct Errors {
    double squares = 0.0, sum = 0.0;
    int count = 0;

    void add(double value, double truth) {
        const double error = value / truth - 1.0;
        squares += error * error;
        sum += error;
        ++count;
    }
    double rms() const { return std::sqrt(squares / count); }
    double bias() const { return std::abs(sum / count); }
};

TEST(RectangleLight, HasTheIrradianceOfALambertianRectangle) {
    const RectangleLight light = panel();
    const BakeResult result = test::bake(test::sceneWith(light), test::uniformFields(test::cube(32, 1.0)));
    const Lattice& lattice = result.light.lattice;
    Errors scalar, normal;
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        const glm::dvec3 x = lattice.worldFromIndex(v);
        if (x.z < light.position.z + 0.4 || glm::any(glm::greaterThan(glm::abs(x), glm::dvec3(0.9)))) return;
        const double irradiance = result.light.irradiance.at(v).x;
        scalar.add(irradiance, radianceOf(light) * overRectangle(light, x, quadrantSolidAngle));
        normal.add(irradiance * double(result.light.lightDirection.at(v).z),
                   radianceOf(light) * overRectangle(light, x, quadrantProjectedSolidAngle));
    });
    // the promise for a point light; strata of 0.13 at a distance of 0.4 and more are off by (0.13/0.4)²/12 of the
    // irradiance's curvature where they are nearest, far less on the average
    EXPECT_LE(scalar.rms(), 0.02);
    EXPECT_LE(scalar.bias(), 0.002);
    EXPECT_LE(normal.rms(), 0.02);
    EXPECT_LE(normal.bias(), 0.002);
}

TEST(RectangleLight, LightsItsFrontOnly) {
    RectangleLight light = panel();
    light.samples = 4;
    const BakeResult result = test::bake(test::sceneWith(light), test::uniformFields(test::cube(24, 1.0)));
    const Lattice& lattice = result.light.lattice;
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        // hats reach one voxel further
        if (lattice.worldFromIndex(v).z < light.position.z - lattice.voxel) {
            EXPECT_EQ(result.light.irradiance.at(v), glm::vec3(0.0f));
        } else if (lattice.worldFromIndex(v).z > light.position.z + lattice.voxel) {
            EXPECT_GT(result.light.irradiance.at(v).x, 0.0f);
        }
    });
}

TEST(RectangleLight, LedgerHoldsAllItsPower) {
    RectangleLight light = panel();
    light.direction = glm::normalize(glm::dvec3(0.2, -1.0, 0.4));
    light.position = {0.0, 0.3, 0.1};
    light.power = glm::dvec3(1.0, 2.0, 3.0);
    light.samples = 8;
    const EnergyLedger energy =
        test::bake(test::sceneWith(light), test::uniformFields(test::cube(24, 1.0))).statistics.energy;
    EXPECT_EQ(energy.emitted, light.power);
    for (int band = 0; band < 3; ++band) {
        // corners stand for the mean of a patch: the trapezoidal rule on the cosine, (1/16)²/6 with cells of a cube's 16th
        EXPECT_NEAR(energy.entered[band], light.power[band], 1e-3 * light.power[band]);
        EXPECT_NEAR(energy.exited[band] + energy.culled[band], energy.entered[band], 1e-5 * light.power[band]);
    }
}

TEST(RectangleLight, FromOutsideTheDomainLosesWhatPassesIt) {
    RectangleLight light = panel();
    light.position = {0.0, 0.0, -4.0};
    light.samples = 4;
    const BakeResult result = test::bake(test::sceneWith(light), test::uniformFields(test::cube(32, 1.0)));
    // in the far field: a point of axial intensity Φ/π
    const double irradiance = light.power.x / std::numbers::pi / (4.0 * 4.0);
    double middle = 0.0;
    for (int i = 0; i < 8; ++i) {
        middle += result.light.irradiance.at(15 + (i & 1), 15 + ((i >> 1) & 1), 15 + (i >> 2)).x / 8.0;
    }
    EXPECT_NEAR(middle, irradiance, 0.02 * irradiance);  // the light's size over its distance: 0.2²/12; the beat of patches
    EXPECT_LT(result.statistics.energy.entered.x, 0.2 * light.power.x);
}

TEST(RectangleLight, StrataAreNearlySquareAndAtMostAsManyAsAskedFor) {
    RectangleLight light = panel();
    const auto sources = bake::pointSourcesOf(light);
    ASSERT_EQ(sources.size(), 32u);  // 8 columns, 4 rows
    light.samples = 16;
    light.size = {1.0, 1.0};
    EXPECT_EQ(bake::pointSourcesOf(light).size(), 16u);
    light.size = {1.0, 100.0};
    EXPECT_EQ(bake::pointSourcesOf(light).size(), 16u);
    glm::dvec3 sum(0.0), mean(0.0);
    for (const bake::PointSource& source : sources) {
        sum += source.intensity * std::numbers::pi;  // a cosine's flux is π times its axial intensity
        mean += source.position / double(sources.size());
    }
    EXPECT_NEAR(sum.x, light.power.x, 1e-12);
    EXPECT_LT(glm::distance(mean, light.position), 1e-15);
    // width is across `up`, which is y here
    EXPECT_NEAR(std::abs(sources.front().position.x), 0.35, 1e-12);
    EXPECT_NEAR(std::abs(sources.front().position.y), 0.15, 1e-12);
}

} // namespace
} // namespace eikonal
