// Reflected wavefronts: Fresnel's share of the light in front of glass, the series between two faces, the rainbow.
#include <numbers>

#include "common/physics.h"
#include "tests/lightsim/bake_scenes.h"

namespace eikonal {
namespace {

/// Index `inside` where `distance` is negative, boundaries smoothed.
Fields glassFields(const Lattice& lattice, double inside, const std::function<double(const glm::dvec3&)>& distance,
                   double widthVoxels = 1.5) {
    const double width = widthVoxels * lattice.voxel;
    Fields fields = test::indexFields(lattice, [&](const glm::dvec3& x) {
        return 1.0 + (inside - 1.0) * 0.5 * std::erfc(distance(x) / (std::sqrt(2.0) * width));
    });
    fields.interface = DenseGrid<unsigned char>(lattice.size, 0);
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        fields.interface.at(v) = std::abs(distance(lattice.worldFromIndex(v))) < 2.75 * width ? 255 : 0;
    });
    return fields;
}

BakeResult bakeBeam(const Fields& fields, const glm::dvec3& direction, int reflections) {
    Scene scene = test::sceneWith(DirectionalLight{glm::normalize(direction), glm::dvec3(1.0)});
    scene.accuracy.reflections = reflections;
    return test::bake(scene, fields);
}

glm::ivec3 voxelAt(const Lattice& lattice, const glm::dvec3& x) {
    return glm::ivec3(glm::floor((x - lattice.min) / lattice.voxel));
}

/// Reflectance from vacuum, unpolarised.
double reflectanceAt(double degrees, double n) {
    const f64::Polarised r = f64::fresnelReflectance(1.0, n, std::sin(glm::radians(degrees)));
    return 0.5 * (r.s + r.p);
}

class InterfaceAt : public ::testing::TestWithParam<double> {};

TEST_P(InterfaceAt, LightsWhatIsInFront) {
    // glass fills x > 0; the beam comes from vacuum, in the plane of x and y
    const Lattice lattice = test::cube(32, 1.0);
    const Fields fields = glassFields(lattice, 1.5, [](const glm::dvec3& x) { return -x.x; });
    const double angle = glm::radians(GetParam());
    const BakeResult result = bakeBeam(fields, {std::cos(angle), std::sin(angle), 0.0}, 1);
    const double r = reflectanceAt(GetParam(), 1.5);
    const glm::dvec2 flux((1.0 - r) * std::cos(angle), (1.0 + r) * std::sin(angle));
    for (const glm::dvec3& x : {glm::dvec3(-0.3, 0.5, 0.0), glm::dvec3(-0.35, 0.6, 0.3), glm::dvec3(-0.3, 0.4, -0.4)}) {
        const glm::ivec3 voxel = voxelAt(lattice, x);
        // on either side of the band 0.3 % of the step is left: R is short by 2.4 %; direct light is even to 0.5 %
        EXPECT_NEAR(result.light.irradiance.at(voxel).x, 1.0 + r, 0.024 * r + 0.005);
        const glm::vec3 direction = result.light.lightDirection.at(voxel);
        // rays may be 0.15 voxel off across cells of eight
        EXPECT_NEAR(direction.x, flux.x / (1.0 + r), 0.01);
        EXPECT_NEAR(direction.y, flux.y / (1.0 + r), 0.01);
        EXPECT_NEAR(direction.z, 0.0, 0.001);
    }
    // all is followed, none twice; the meshes of both paths know the domain's edge to half a voxel of 32
    EXPECT_NEAR(result.statistics.energy.reflected.x, 0.0, 0.03 * result.statistics.energy.followed.x);
    EXPECT_NEAR(result.statistics.energy.balance().x, 0.0, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Reflections, InterfaceAt, ::testing::Values(0.0, 45.0, 60.0));

TEST(Reflections, BetweenTwoFacesAreAGeometricSeries) {
    // a slab of n = 2: R = 1/9 at each face
    const Lattice lattice = test::cube(32, 1.0);
    const Fields fields = glassFields(lattice, 2.0, [](const glm::dvec3& x) { return std::abs(x.x) - 0.4; });
    const double r = 1.0 / 9.0, t = 1.0 - r;
    const auto irradiance = [&](const BakeResult& result, double x) {
        return double(result.light.irradiance.at(voxelAt(lattice, {x, 0.0, 0.0})).x);
    };
    const BakeResult once = bakeBeam(fields, {1.0, 0.0, 0.0}, 1);
    const BakeResult twice = bakeBeam(fields, {1.0, 0.0, 0.0}, 2);
    // R is short by 2.4 % (see above), its square by 4.8 %
    EXPECT_NEAR(irradiance(once, -0.8), 1.0 + r + t * t * r, 0.006);
    EXPECT_NEAR(irradiance(once, 0.0), t * (1.0 + r), 0.006);
    EXPECT_NEAR(irradiance(once, 0.8), t * t, 0.006);
    EXPECT_NEAR(irradiance(twice, -0.8) - irradiance(once, -0.8), 0.0, 1e-4);
    EXPECT_NEAR(irradiance(twice, 0.0) - irradiance(once, 0.0), t * r * r, 0.06 * t * r * r);
    EXPECT_NEAR(irradiance(twice, 0.8) - irradiance(once, 0.8), t * t * r * r, 0.06 * t * t * r * r);
    EXPECT_NEAR(twice.statistics.energy.exited.x / twice.statistics.energy.entered.x,
                r + t * t * (1.0 + r + r * r), 0.003);
}

Fields tinted(Fields fields, const glm::vec3& tint) {
    fields.reflectionTint = DenseGrid<glm::vec3>(fields.lattice.size, tint);
    return fields;
}

TEST(Reflections, OfATintedFaceAreColoured) {
    // glass fills x > 0, and grey light falls on it
    const Lattice lattice = test::cube(32, 1.0);
    const Fields plain = glassFields(lattice, 1.5, [](const glm::dvec3& x) { return -x.x; });
    const glm::dvec3 tint(1.0, 0.6, 0.0);  // as bytes hold it: 153/255
    const Fields fields = tinted(plain, glm::vec3(tint));
    const double reflected = bakeBeam(plain, {1.0, 0.0, 0.0}, 0).statistics.energy.reflected.x;
    const BakeResult off = bakeBeam(fields, {1.0, 0.0, 0.0}, 0);
    const BakeResult on = bakeBeam(fields, {1.0, 0.0, 0.0}, 1);
    const double r = reflectanceAt(0.0, 1.5);
    const glm::vec3 inFront = on.light.irradiance.at(voxelAt(lattice, {-0.35, 0.2, 0.3}));
    for (int band = 0; band < 3; ++band) {
        EXPECT_NEAR(inFront[band], 1.0 + r * tint[band], 0.024 * r + 0.005);  // as of a face without tint
        for (const BakeResult* result : {&off, &on}) {
            const EnergyLedger& energy = result->statistics.energy;
            // the same rays: only rounding is between them
            EXPECT_NEAR(energy.absorbedByTint[band], (1.0 - tint[band]) * reflected, 1e-5 * reflected);
            EXPECT_NEAR(energy.absorbed[band], energy.absorbedByTint[band], 1e-5 * reflected);
            EXPECT_NEAR(energy.balance()[band], 0.0, 1e-4);
        }
        EXPECT_NEAR(off.statistics.energy.reflected[band], tint[band] * reflected, 1e-5 * reflected);
        // the meshes of both paths know the domain's edge to half a voxel of 32
        EXPECT_NEAR(on.statistics.energy.followed[band], tint[band] * reflected, 0.03 * reflected);
    }
}

TEST(Reflections, BetweenTintedFacesAreTintedAgainAndAgain) {
    // a slab of n = 2: R = 1/9 at each face, three fifths of it left
    const Lattice lattice = test::cube(32, 1.0);
    const Fields fields =
        tinted(glassFields(lattice, 2.0, [](const glm::dvec3& x) { return std::abs(x.x) - 0.4; }), glm::vec3(0.6f));
    const double r = 1.0 / 9.0, t = 1.0 - r, tint = 0.6;
    const auto irradiance = [&](const BakeResult& result, double x) {
        return double(result.light.irradiance.at(voxelAt(lattice, {x, 0.0, 0.0})).x);
    };
    const BakeResult once = bakeBeam(fields, {1.0, 0.0, 0.0}, 1);
    const BakeResult twice = bakeBeam(fields, {1.0, 0.0, 0.0}, 2);
    // tolerances as of faces without tint
    EXPECT_NEAR(irradiance(once, -0.8), 1.0 + tint * (r + t * t * r), 0.006);
    EXPECT_NEAR(irradiance(once, 0.0), t * (1.0 + tint * r), 0.006);
    EXPECT_NEAR(irradiance(twice, 0.0) - irradiance(once, 0.0), t * tint * tint * r * r, 0.06 * t * tint * tint * r * r);
    EXPECT_NEAR(twice.statistics.energy.balance().x, 0.0, 1e-4);
    // at the front, at the back, at the front again from inside, and at the back once more
    const double taken = (1.0 - tint) * (r + t * r + tint * t * r * r + tint * tint * t * r * r * r);
    EXPECT_NEAR(twice.statistics.energy.absorbedByTint.x / twice.statistics.energy.entered.x, taken, 0.003);
}

TEST(Reflections, WithoutBoundariesAreNone) {
    const Fields fields = test::clearSphere(16);
    const BakeResult off = bakeBeam(fields, {1.0, 0.0, 0.0}, 0);
    const BakeResult on = bakeBeam(fields, {1.0, 0.0, 0.0}, 3);
    EXPECT_EQ(on.light.irradiance.values, off.light.irradiance.values);
    EXPECT_EQ(on.statistics.patches.steps, off.statistics.patches.steps);
}

/// What a sphere reflects of a unit beam at its first two crossings, by Fresnel's equations for either polarisation.
double powerReflectedBySphere(double radius, double n) {
    constexpr int kSteps = 20000;
    double power = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double p = (i + 0.5) / kSteps;  // impact parameter over the radius
        const f64::Polarised r = f64::fresnelReflectance(1.0, n, p);
        const double mean = 0.5 * (r.s * (2.0 - r.s) + r.p * (2.0 - r.p));
        power += mean * 2.0 * std::numbers::pi * p * radius * radius / kSteps;
    }
    return power;
}

/// The light that following reflections adds.
DenseGrid<double> addedBy(const BakeResult& on, const BakeResult& off) {
    DenseGrid<double> added(on.light.lattice.size, 0.0);
    for (std::size_t i = 0; i < added.values.size(); ++i) {
        added.values[i] = double(on.light.irradiance.values[i].x) - double(off.light.irradiance.values[i].x);
    }
    return added;
}

TEST(Reflections, OfASphereCarryWhatFresnelSays) {
    const Lattice lattice = test::cube(48, 1.0);
    const auto sphereAt = [&](const glm::dvec3& centre) {
        return glassFields(lattice, 1.5, [=](const glm::dvec3& x) { return glm::length(x - centre) - 0.6; });
    };
    const Fields fields = sphereAt(glm::dvec3(0.0));
    const BakeResult off = bakeBeam(fields, {1.0, 0.0, 0.0}, 0);
    const BakeResult on = bakeBeam(fields, {1.0, 0.0, 0.0}, 1);
    const double followed = on.statistics.energy.followed.x;
    // Rays that pass up to 1.03 radii off meet the smoothed rim too, where R is largest: a hundredth of the power. With where
    // the rim lies between rays and voxels it varies by as much either way: the mean over two places.
    const BakeResult aside = bakeBeam(sphereAt(lattice.voxel * glm::dvec3(0.35, 0.45, 0.5)), {1.0, 0.0, 0.0}, 0);
    EXPECT_NEAR(0.5 * (off.statistics.energy.reflected.x + aside.statistics.energy.reflected.x), powerReflectedBySphere(0.6, 1.5),
                0.02 * followed);
    // a third of it comes from the last voxel within the rim, where R rises to 1 between rays half a voxel apart
    EXPECT_NEAR(followed, off.statistics.energy.reflected.x, 0.04 * followed);
    EXPECT_NEAR(on.statistics.energy.balance().x, 0.0, 1e-4);

    const DenseGrid<double> added = addedBy(on, off);
    double sum = 0.0, odd = 0.0;
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        sum += std::abs(added.at(v));
        odd += std::abs(added.at(v) - added.at(v.x, lattice.size.y - 1 - v.y, v.z));
    });
    EXPECT_LT(odd, 0.03 * sum);  // the mesh is symmetric too, but the sides of a cell are not always halved alike
}

/// A ray that enters a sharp sphere of radius 1 about the origin along +x, is reflected inside once and leaves.
struct ReflectedInside {
    glm::dvec2 exit;       // along the axis, across it
    glm::dvec2 direction;  // unit
};

ReflectedInside throughDrop(double impact, double n) {
    const double incidence = std::asin(impact), refraction = std::asin(impact / n);
    // each chord turns the place by π - 2 refraction, each refraction the ray by incidence - refraction
    const double place = -std::numbers::pi - incidence + 4.0 * refraction;
    const double travel = -(std::numbers::pi + 2.0 * incidence - 4.0 * refraction);
    return {{std::cos(place), std::sin(place)}, {std::cos(travel), std::sin(travel)}};
}

/// Of all rays reflected inside a drop of radius 1, the furthest from the axis in the plane at `planeX`, and the least angle
/// that any is turned by [degrees].
struct Rainbow {
    double fold = 0.0;
    double leastDeviation = 180.0;
};

Rainbow rainbowOf(double n, double planeX) {
    Rainbow rainbow;
    for (double impact = 0.001; impact < 1.0; impact += 0.001) {
        const ReflectedInside ray = throughDrop(impact, n);
        rainbow.leastDeviation = std::min(rainbow.leastDeviation, glm::degrees(std::acos(ray.direction.x)));
        if (ray.direction.x < 0.0 && ray.exit.x > planeX) {
            const double along = (planeX - ray.exit.x) / ray.direction.x;
            rainbow.fold = std::max(rainbow.fold, -(ray.exit.y + along * ray.direction.y));
        }
    }
    return rainbow;
}

TEST(Reflections, InsideADropMakeTheRainbow) {
    const double n = 1.333, radius = 0.5;
    const glm::dvec3 centre(0.3, 0.0, 0.0);
    const Lattice lattice = test::cube(48, 1.2);
    const Fields fields = glassFields(lattice, n, [&](const glm::dvec3& x) { return glm::distance(x, centre) - radius; }, 1.0);
    const BakeResult off = bakeBeam(fields, {1.0, 0.0, 0.0}, 0);
    const BakeResult on = bakeBeam(fields, {1.0, 0.0, 0.0}, 1);
    const DenseGrid<double> added = addedBy(on, off);

    // across a plane in front of the drop
    const glm::ivec3 plane = voxelAt(lattice, {-0.3, 0.0, 0.0});
    const Rainbow rainbow = rainbowOf(n, (lattice.worldFromIndex(plane).x - centre.x) / radius);
    ASSERT_NEAR(rainbow.leastDeviation, 180.0 - 42.08, 0.1);

    glm::ivec3 brightest(plane.x, 0, plane.z);
    for (int j = 0; lattice.worldFromIndex({0, j, 0}).y < -0.8; ++j) {  // further in it is bright near the axis
        if (added.at(plane.x, j, plane.z) > added.at(brightest)) {
            brightest.y = j;
        }
    }
    const auto fluxOf = [&](const BakeResult& result) {
        return glm::dvec3(result.light.lightDirection.at(brightest)) * double(result.light.irradiance.at(brightest).x);
    };
    const glm::dvec3 flux = fluxOf(on) - fluxOf(off);
    // a smoothed sphere turns a ray by up to 0.4 Δn b/R less or more at each of three boundaries: 2.3 degrees in all, which is
    // a voxel at this distance
    EXPECT_NEAR(-lattice.worldFromIndex(brightest).y, radius * rainbow.fold, 2.0 * lattice.voxel);
    EXPECT_LT(added.at(plane.x, 0, plane.z), 0.1 * added.at(brightest));  // dark beyond it
    EXPECT_NEAR(glm::degrees(std::acos(flux.x / glm::length(flux))), rainbow.leastDeviation, 4.0);
}

TEST(Reflections, KeepTheEnergyOfTheGrid) {
    // as fine as the ledger's own test: on 32 voxels absorption and irradiance vary together within those of the boundary by 0.4 %,
    // however many samples their means are taken from
    const Fields fields = test::absorbingSphereInSmoke(48);
    const EnergyLedger energy = bakeBeam(fields, {1.0, 0.2, 0.1}, 2).statistics.energy;
    for (int band = 0; band < 3; ++band) {
        EXPECT_GT(energy.followed[band], 0.0);
        EXPECT_LT(energy.reflected[band], 0.1 * energy.followed[band]);
        EXPECT_NEAR(energy.balance()[band], 0.0, 1e-4);
        EXPECT_NEAR(energy.depositedAbsorbed[band], energy.absorbed[band], 0.005 * energy.absorbed[band]);
        EXPECT_NEAR(energy.depositedScattered[band], energy.scattered[band], 0.005 * energy.scattered[band]);
    }
}

} // namespace
} // namespace eikonal
