// The eikonal against closed forms and rays in double precision: distance, the nearer of two lights, lenses, shadows.
#include "common/physics.h"
#include "common/reference/reference_field.h"
#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

DenseGrid<float> eikonalOf(const Scene& scene, const Fields& fields) {
    BakeOptions options;
    options.eikonal = true;
    return test::bake(scene, fields, options).light.eikonal;
}

// [voxels]: rays may be 0.15 from where linear interpolation between their neighbours has them, and the grid is interpolated
constexpr double kBetweenRays = 0.2;

const DirectionalLight kBeam{{1.0, 0.0, 0.0}, glm::dvec3(1.0)};

TEST(Eikonal, OfPointLightsIsTheDistanceToTheNearest) {
    const Lattice lattice = test::cube(24, 1.0);
    const glm::dvec3 inside(0.1, 0.05, -0.2), outside(-3.0, 0.4, 0.0);
    Scene scene = test::sceneWith(PointLight{inside, glm::dvec3(1.0)});
    scene.lights.push_back(PointLight{outside, glm::dvec3(5.0)});
    const DenseGrid<float> both = eikonalOf(scene, test::uniformFields(lattice));
    scene.lights.erase(scene.lights.begin());
    const DenseGrid<float> far = eikonalOf(scene, test::uniformFields(lattice));
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        const glm::dvec3 x = lattice.worldFromIndex(v);
        const double near = glm::distance(x, inside);
        if (near > 2.0 * lattice.voxel) {
            EXPECT_NEAR(both.at(v), near, kBetweenRays * lattice.voxel);
        }
        EXPECT_NEAR(far.at(v), glm::distance(x, outside), kBetweenRays * lattice.voxel);
    });
}

TEST(Eikonal, OfTheNearestLightCounts) {
    const Lattice lattice = test::cube(16, 1.0);
    Scene scene = test::sceneWith(PointLight{{-2.0, 0.0, 0.0}, glm::dvec3(1.0)});
    scene.lights.push_back(PointLight{{2.5, 0.0, 0.0}, glm::dvec3(1.0)});
    const DenseGrid<float> eikonal = eikonalOf(scene, test::uniformFields(lattice));
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        const glm::dvec3 x = lattice.worldFromIndex(v);
        const double nearest = std::min(glm::distance(x, {-2.0, 0.0, 0.0}), glm::distance(x, {2.5, 0.0, 0.0}));
        EXPECT_NEAR(eikonal.at(v), nearest, kBetweenRays * lattice.voxel);
    });
}

TEST(Eikonal, OfALuneburgLensIsItsClosedForm) {
    const Lattice lattice = test::cube(54, 1.125);
    const Fields fields = test::indexFields(lattice, [](const glm::dvec3& x) {
        return std::sqrt(std::max(2.0 - glm::dot(x, x), 1.0));
    });
    const DenseGrid<float> eikonal = eikonalOf(test::sceneWith(kBeam), fields);
    // x(τ) = x0 cos τ + w0 sin τ from where the ray meets the lens, n² = 1 - (x0·w0) sin 2τ along it, optical path from the
    // plane x = -1: 1 - c + τ + c sin² τ with c = -x0·w0; 1 + π/2 at the far pole for every ray. The domain begins before it
    constexpr double kBefore = 0.125;
    for (const double y : {0.05, 0.3, 0.6}) {
        const double c = std::sqrt(1.0 - y * y);
        for (const double tau : {0.3, 0.7, 1.1, 1.4}) {
            const glm::dvec3 x(-c * std::cos(tau) + std::sin(tau), y * std::cos(tau), 0.0);
            const double path = kBefore + 1.0 - c + tau + c * std::pow(std::sin(tau), 2.0);
            EXPECT_NEAR(reference::trilinear(eikonal, lattice, x), path, kBetweenRays * lattice.voxel) << "y " << y << ", τ " << tau;
        }
    }
    // the pole is a focus: light comes to the voxels about it, 0.87 voxels off, from their own side first
    EXPECT_NEAR(reference::trilinear(eikonal, lattice, glm::dvec3(1.0, 0.0, 0.0)), kBefore + 1.0 + std::acos(-1.0) / 2.0,
                lattice.voxel);
}

TEST(Eikonal, BehindASmoothedSphereIsThatOfRays) {
    const Lattice lattice = test::cube(48, 1.0);
    const double width = 1.5 * lattice.voxel;
    const reference::SmoothedSphere sphere(0.6, 1.5, width);
    const DenseGrid<float> eikonal = eikonalOf(test::sceneWith(kBeam), test::clearSphere(48));
    const double ds = 0.02 * lattice.voxel;
    for (const double impact : {0.02, 0.15, 0.3, 0.7}) {
        f64::Ray ray{{-1.0, impact, 0.0}, {1.0, 0.0, 0.0}};
        double path = 0.0;
        for (int step = 0; ray.x.x < 0.4; ++step) {  // rays through the rim come to the back first
            ray = f64::driftByLength(ray, 0.5 * ds);
            const auto optics = sphere.optics(ray.x);
            ray = f64::driftByLength(f64::kickByLength(ray, optics.gradN, ds), 0.5 * ds);
            path += optics.n * ds;
            if (step % 400 == 399 && ray.x.x > -0.9) {
                EXPECT_NEAR(reference::trilinear(eikonal, lattice, ray.x), path, kBetweenRays * lattice.voxel) << impact << " at x = " << ray.x.x;
            }
        }
    }
}

TEST(Eikonal, HasNoPathInShadow) {
    const Lattice lattice = test::cube(16, 1.0);
    Fields fields = test::uniformFields(lattice);
    fields.opaque = test::boxCoverage(lattice, {-0.125, -0.5, -0.5}, {0.125, 0.5, 0.5});
    fields.albedo = DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.8f));
    const DenseGrid<float> eikonal = eikonalOf(test::sceneWith(kBeam), fields);
    EXPECT_EQ(eikonal.at(14, 8, 8), kUnreached);
    EXPECT_NEAR(eikonal.at(14, 2, 8), lattice.worldFromIndex({14, 2, 8}).x + 1.0, 0.01 * lattice.voxel);
    EXPECT_EQ(eikonalOf(Scene{}, fields).at(3, 3, 3), kUnreached);  // no light at all
    EXPECT_TRUE(test::bake(test::sceneWith(kBeam), fields).light.eikonal.empty());  // not asked for
}

} // namespace
} // namespace eikonal
