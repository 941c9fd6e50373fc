// What boundaries let through and mirror, through the image: Fresnel's equations at a smoothed plane, series of reflections
// between two faces, matter that is seen by reflection.
#include <cmath>

#include "common/physics.h"
#include "tests/support/synthetic_fields.h"
#include "viewer/render.h"

namespace eikonal {
namespace {

constexpr double kGlass = 1.5;
constexpr double kWidthVoxels = 1.5;

double coverage(double distance, double width) { return 0.5 * std::erfc(distance / (std::sqrt(2.0) * width)); }

/// Index n where `distance` is negative, boundaries smoothed.
template <class Distance>
Fields glassFields(const Lattice& lattice, double n, const Distance& distance) {
    const double width = kWidthVoxels * lattice.voxel;
    Fields fields =
        test::indexFields(lattice, [&](const glm::dvec3& x) { return 1.0 + (n - 1.0) * coverage(distance(x), width); });
    fields.interface = DenseGrid<unsigned char>(lattice.size, 0);
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        fields.interface.at(v) = std::abs(distance(lattice.worldFromIndex(v))) < 2.75 * width ? 255 : 0;
    });
    return fields;
}

/// One pixel, seen from a place in a direction.
RenderResult seen(Scene scene, const Fields& fields, const glm::dvec3& from, const glm::dvec3& direction) {
    scene.camera.position = from;
    scene.camera.lookAt = from + direction;
    scene.camera.fov = 0.01;
    scene.render.size = glm::ivec2(1);
    return renderScene(test::sharedContext(), scene, fields, test::effectsOf(scene, fields), nullptr);
}

struct Incidence {
    const char* name;
    double n1, n2;
    double degrees;
};

const double kBrewster = glm::degrees(std::atan(kGlass));

class FresnelAt : public ::testing::TestWithParam<Incidence> {};

TEST_P(FresnelAt, IsExactThroughASmoothedPlane) {
    const Incidence incidence = GetParam();
    // a plane along no axis of the voxels, glass behind it
    const glm::dvec3 normal = glm::normalize(glm::dvec3(2.0, 3.0, 6.0));
    const glm::dvec3 along = glm::normalize(glm::cross(normal, glm::dvec3(1.0, 0.0, 0.0)));
    const Fields fields =
        glassFields(test::cube(64, 1.0), kGlass, [&](const glm::dvec3& x) { return glm::dot(x, normal); });
    const double side = incidence.n1 > incidence.n2 ? -1.0 : 1.0;  // of the camera
    const double angle = glm::radians(incidence.degrees);
    const glm::dvec3 direction = -side * std::cos(angle) * normal + std::sin(angle) * along;
    const Scene scene = test::plainScene(glm::dvec3(1.0), 1.0, 1.0, 1);
    const RenderResult image = seen(scene, fields, -0.5 * direction, direction);

    const f64::Polarised r = f64::fresnelReflectance(incidence.n1, incidence.n2, incidence.n1 * std::sin(angle));
    const bool total = r.s == 1.0;
    // beyond the critical angle the field turns the ray round, which is no crossing and takes nothing
    const double exact = total ? 1.0 : 1.0 - 0.5 * (r.s + r.p);
    EXPECT_NEAR(image.channel("throughput.G").values[0], exact, 0.02);
    EXPECT_NEAR(image.radiance(0, 0).g, incidence.n1 * incidence.n1, 0.005);  // white stays white, L/n² is kept
    if (total) {
        const glm::dvec3 mirrored = direction - 2.0 * glm::dot(direction, normal) * normal;
        const glm::dvec3 exit(image.channel("exit.X").values[0], image.channel("exit.Y").values[0],
                              image.channel("exit.Z").values[0]);
        EXPECT_LE(glm::length(exit - mirrored), 2e-3);  // interpolation, where the ray runs along the boundary
    }
}

INSTANTIATE_TEST_SUITE_P(
    Boundaries, FresnelAt,
    ::testing::Values(Incidence{"head_on", 1.0, kGlass, 0.0}, Incidence{"at_45", 1.0, kGlass, 45.0},
                      Incidence{"at_brewsters_angle", 1.0, kGlass, kBrewster},
                      Incidence{"from_glass_head_on", kGlass, 1.0, 0.0}, Incidence{"from_glass_at_30", kGlass, 1.0, 30.0},
                      Incidence{"from_glass_at_brewsters_angle", kGlass, 1.0, 90.0 - kBrewster},
                      Incidence{"beyond_the_critical_angle", kGlass, 1.0, 45.0},
                      Incidence{"far_beyond_the_critical_angle", kGlass, 1.0, 65.0}),
    [](const auto& incidence) { return std::string(incidence.param.name); });

Scene reflectingScene(int generations, const glm::dvec3& surroundings = glm::dvec3(1.0)) {
    Scene scene = test::plainScene(surroundings, 4.0, 40.0, 24);
    scene.accuracy.reflections = generations;
    return scene;
}

/// A level plate of that index.
Fields plate(double n) {
    return glassFields(test::cube(48, 1.0), n, [](const glm::dvec3& x) { return std::abs(x.y) - 0.4; });
}

/// Bright above, dark below.
Scene skyScene(int generations) {
    Scene scene = reflectingScene(generations);
    scene.environment.gradient = {glm::dvec3(0.0), glm::dvec3(1.0)};
    return scene;
}

glm::vec3 seenFromAbove(const Scene& scene, const Fields& fields) {
    return seen(scene, fields, {0.0, 0.8, 0.0}, {0.0, -1.0, 0.0}).radiance(0, 0);
}

TEST(FollowedReflections, BetweenTwoFacesAreAGeometricSeries) {
    const double r = 1.0 / 9.0, t = 1.0 - r;  // of a face at n = 2, head on
    const auto above = [](int generations) {
        return double(seenFromAbove(skyScene(generations), plate(2.0)).g);
    };
    // 0.3 % of the step is left on either side of a band: R is short by 2 % in all
    const double once = r + t * r * t;
    EXPECT_NEAR(above(1), once, 0.02 * once);
    // what the upper face reflects down again is lost below; the lower face returns it once more
    EXPECT_NEAR(above(3) - above(1), t * r * r * r * t, 0.08 * t * r * r * r * t);
    EXPECT_NEAR(above(0), r + t * r, 0.02 * once) << "the environment, as if the upper face were not there";
}

TEST(FollowedReflections, ShowWhatIsBehindTheCamera) {
    // glass of n = 2 below, a grey ceiling above, the camera between them
    const double r = 1.0 / 9.0, albedo = 0.25;
    const Lattice lattice = test::cube(48, 1.0);
    Fields fields = glassFields(lattice, 2.0, [](const glm::dvec3& x) { return x.y; });
    fields.opaque = test::boxCoverage(lattice, {-1.0, 0.8, -1.0}, {1.0, 1.0, 1.0});
    fields.albedo = DenseGrid<glm::vec3>(lattice.size, glm::vec3(float(albedo)));
    const auto below = [&](int generations) {
        return double(seen(reflectingScene(generations), fields, {0.0, 0.5, 0.0}, {0.0, -1.0, 0.0}).radiance(0, 0).g);
    };
    EXPECT_NEAR(below(1), (1.0 - r) + r * albedo, 0.02 * r);
    EXPECT_NEAR(below(0), 1.0, 1e-4) << "not followed: the environment";
}

TEST(FollowedReflections, FromTheOutsideOfAnAbsorberAreClear) {
    const double r = 1.0 / 9.0;
    Fields fields = plate(2.0);
    const glm::vec3 sigma(5.0f, 20.0f, 60.0f);
    fields.sigmaA = test::boxGrid(fields.lattice, {-1.0, -0.4, -1.0}, {1.0, 0.4, 1.0}, sigma);
    const glm::vec3 radiance = seenFromAbove(skyScene(1), fields);
    // the voxel that the face cuts absorbs on either side of it, and the mirror is known to half a step: a quarter of a voxel, and
    // back. Half a boundary, four voxels, would leave a twenty-eighth of the green.
    for (int band = 0; band < 3; ++band) {
        const double dimmest = r * std::exp(-0.5 * sigma[band] * fields.lattice.voxel);
        EXPECT_LE(radiance[band], r) << band;
        EXPECT_GE(radiance[band], 0.97 * dimmest) << band;  // R is short by 2.4 %
    }
}

TEST(FollowedReflections, KeepTheFurnaceWhite) {
    const Fields fields = test::sphereFields(test::cube(48, 1.0), 0.7, kGlass, kWidthVoxels / 24.0);
    const Scene scene = reflectingScene(4);
    const RenderResult image =
        renderScene(test::sharedContext(), scene, fields, test::effectsOf(scene, fields), nullptr);
    for (int i = 0; i < 24 * 24; ++i) ASSERT_NEAR(image.radiance(i % 24, i / 24).g, 1.0, 1e-3) << i;
    // the sphere fills a sixth of the image; each ray is reflected at its first crossing, at its second, and the latter again
    EXPECT_GT(image.statistics.reflectedRays, 24u * 24u / 6u * 2u);
}

TEST(FollowedReflections, AreTheSameBitsInAnySlicesAndTiles) {
    Fields fields = test::sphereFields(test::cube(32, 1.0), 0.7, kGlass, kWidthVoxels / 16.0);
    fields.sigmaA = test::boxGrid(fields.lattice, glm::dvec3(-0.3), glm::dvec3(0.3), {0.2f, 1.0f, 2.0f});
    Scene scene = reflectingScene(3);
    scene.environment.gradient = {glm::dvec3(0.9, 0.5, 0.2), glm::dvec3(0.1, 0.3, 0.8)};
    scene.render.samples = 2;
    const auto rendered = [&](const RenderOptions& options) {
        return renderScene(test::sharedContext(), scene, fields, test::effectsOf(scene, fields), nullptr, options);
    };
    const RenderResult whole = rendered({}), pieces = rendered({.stepsPerSlice = 7, .tileRays = 100});
    for (std::size_t c = 0; c < whole.channels.size(); ++c)
        EXPECT_EQ(whole.channels[c].values, pieces.channels[c].values) << whole.channels[c].name;  // NaN would differ
    EXPECT_EQ(whole.statistics.reflectedRays, pieces.statistics.reflectedRays);
}

TEST(FollowedReflections, CostNothingWhereTheyAreNotAskedFor) {
    const Fields fields = test::sphereFields(test::cube(16, 1.0), 0.7, kGlass, kWidthVoxels / 8.0);
    const auto statistics = [&](int generations) {
        const Scene scene = reflectingScene(generations);
        return renderScene(test::sharedContext(), scene, fields, test::effectsOf(scene, fields), nullptr).statistics;
    };
    const RenderStatistics off = statistics(0), on = statistics(1);
    EXPECT_EQ(off.reflectedRays, 0u);
    EXPECT_LT(off.memoryBytes, on.memoryBytes);
    EXPECT_LT(off.fieldEvaluations, on.fieldEvaluations);
    Fields gradual = fields;
    gradual.interface = {};  // nothing reflects: nothing is made for it
    const Scene scene = reflectingScene(1);
    EXPECT_EQ(renderScene(test::sharedContext(), scene, gradual, test::effectsOf(scene, gradual), nullptr)
                  .statistics.reflectedRays, 0u);
}

} // namespace
} // namespace eikonal
