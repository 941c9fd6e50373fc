// Objects with lattices of their own, seen by viewing rays: against the same objects on the domain's lattice, and against
// closed forms that know no lattice.
#include <algorithm>
#include <cmath>

#include "common/insets.h"
#include "common/physics.h"
#include "common/reference/reference_field.h"
#include "common/stage_fields.h"
#include "tests/support/synthetic_fields.h"
#include "viewer/render.h"
#include "viewer/trace.h"

namespace eikonal {
namespace {

using glm::dvec3;
using test::sharedContext;

/// Voxels that a smoothing of 1.5 takes of an inset's lattice, on both sides together (docs/scene.md).
constexpr int kPadding = 14;

Quantity quantity(const dvec3& value) { return {.constant = value, .expression = std::nullopt, .where = {}, .given = true}; }

Object glassSphere(double radius) {
    Object object;
    object.shape = SphereShape{radius};
    return object;
}

Object box(const dvec3& size, const dvec3& absorption) {
    Object object;
    object.shape = BoxShape{size};
    object.ior = quantity(dvec3(1.0));
    object.absorption = quantity(absorption);
    return object;
}

Scene sceneOf(int domainResolution, std::vector<Object> objects) {
    Scene scene = test::plainScene(dvec3(1.0), 4.0, 30.0, 24);
    scene.domain.resolution = domainResolution;
    scene.objects = std::move(objects);
    return scene;
}

std::vector<TraceResult> traced(const Scene& scene, const Fields& fields, const std::vector<TraceRay>& rays,
                                StraightFlights flights = StraightFlights::kTaken) {
    return traceRays(sharedContext(), fields, test::effectsOf(scene, fields), scene.accuracy, rays, flights);
}

/// Rays along a direction through a disc about a point.
std::vector<TraceRay> parallelRays(double radius, int count, const dvec3& direction, const dvec3& middle) {
    const dvec3 forward = glm::normalize(direction);
    const dvec3 side = glm::normalize(glm::cross(forward, dvec3(0.0, 1.0, 0.0)));
    const dvec3 up = glm::cross(side, forward);
    std::vector<TraceRay> rays;
    for (int i = 0; i < count; ++i) {
        const double r = radius * std::sqrt((i + 0.5) / count), angle = 2.399963229728653 * i;
        rays.push_back({middle + side * (r * std::cos(angle)) + up * (r * std::sin(angle)) - forward * 3.0, forward});
    }
    return rays;
}

TEST(Insets, OnAnAlignedLatticeBendAsOnTheDomains) {
    const int across = 32;
    Scene scene = sceneOf(2 * across, {glassSphere(0.5)});
    scene.objects[0].absorption = quantity({1.0, 2.0, 0.5});
    const Fields onDomain = composeFields(scene);
    scene.objects[0].resolution = across + kPadding;
    const Fields withInset = composeImageFields(scene);
    ASSERT_EQ(withInset.insets.size(), 1u);
    EXPECT_DOUBLE_EQ(voxelOf(withInset.insets[0]), onDomain.lattice.voxel);
    const auto rays = parallelRays(0.48, 300, {0.1, -0.2, 1.0}, dvec3(0.0));
    const auto expected = traced(scene, onDomain, rays, StraightFlights::kNone);
    const auto found = traced(scene, withInset, rays, StraightFlights::kNone);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        // n in single precision: 1e-7 over a voxel of 1/32 is a gradient of 4e-6, over paths of a unit; tails of 7e-6 of the
        // contrast end with the inset's lattice; area coverage is a number of 16 bits
        EXPECT_LE(glm::length(found[i].direction - expected[i].direction), 1e-5) << "ray " << i;
        EXPECT_NEAR(found[i].opticalLength, expected[i].opticalLength, 1e-5) << "ray " << i;
        EXPECT_NEAR(found[i].depth.y, expected[i].depth.y, 1e-4) << "ray " << i;
    }
}

/// Direction behind a smoothed sphere about `middle`, by leapfrog in double with steps so small that its error is below 1e-7.
dvec3 directionBehind(const reference::SmoothedSphere& sphere, const dvec3& middle, const TraceRay& input) {
    f64::Ray ray = {input.origin - middle + input.direction * 2.0, input.direction};
    const double h = 1e-3;
    for (int i = 0; i < 2000; ++i) {
        ray = f64::driftByLength(ray, 0.5 * h);
        ray = f64::driftByLength(f64::kickByLength(ray, sphere.optics(ray.x).gradN, h), 0.5 * h);
    }
    return glm::normalize(ray.w);
}

/// RMS error of the directions behind a sphere of radius 0.5 about `middle` with a boundary of `width`.
double rmsErrorBehindSphere(const Scene& scene, const Fields& fields, const dvec3& direction, const dvec3& middle, double width) {
    const reference::SmoothedSphere exact(0.5, 1.5, width);
    const auto rays = parallelRays(0.48, 300, direction, middle);
    const auto found = traced(scene, fields, rays);
    double sum = 0.0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const dvec3 error = found[i].direction - directionBehind(exact, middle, rays[i]);
        sum += glm::dot(error, error);
    }
    return std::sqrt(sum / double(rays.size()));
}

TEST(Insets, TurnedAndShiftedBendAsTheirProfileSaysInACoarseDomain) {
    const int across = 64;
    const dvec3 direction = glm::normalize(dvec3(0.1, -0.2, 1.0));
    const double width = 1.5 / across;
    Scene coarse = sceneOf(12, {glassSphere(0.25)}), fine = sceneOf(2 * across, {glassSphere(0.5)});
    Object& sphere = coarse.objects[0];
    sphere.scale = 2.0;
    sphere.rotate = {20.0, 30.0, 40.0};
    sphere.translate = {0.21, -0.13, 0.17};
    sphere.resolution = across + kPadding;
    const double ofInset =
        rmsErrorBehindSphere(coarse, composeImageFields(coarse), direction, sphere.translate, width);
    // Along the same way through a lattice of the same voxels, which is the domain's.
    const dvec3 turnedBack = glm::transpose(glm::dmat3(sphere.worldFromLocal()) / sphere.scale) * direction;
    const double ofDenseGrid = rmsErrorBehindSphere(fine, composeFields(fine), turnedBack, dvec3(0.0), width);
    EXPECT_LE(ofInset, 1.1 * ofDenseGrid);  // steps begin elsewhere
    EXPECT_LE(ofDenseGrid, 2e-3);           // of trilinear interpolation for b = 1.5 at a radius of 32 voxels
}

TEST(Insets, OfGradedIndexKeepTheInvariantOfBouguer) {
    Object lens;
    lens.shape = FieldShape{dvec3(2.0)};
    lens.ior = {.constant = {}, .expression = "2 / (1 + r^2)", .where = {}, .given = true};
    lens.resolution = 96;
    lens.scale = 0.8;
    lens.rotate = {10.0, -25.0, 50.0};
    lens.translate = {0.05, 0.1, -0.08};
    const Scene scene = sceneOf(8, {lens});
    const Fields fields = composeImageFields(scene);
    const std::vector<TraceRay> rays{{lens.translate + dvec3(0.3, 0.0, 0.0), glm::normalize(dvec3(0.2, 1.0, 0.3))}};
    const auto ratioAt = [&](const TraceResult& at) {
        const dvec3 offset = at.position - lens.translate;
        const double r = glm::length(offset) / lens.scale;
        return glm::length(glm::cross(offset, at.direction)) * 2.0 / (1.0 + r * r);
    };
    const auto points = tracePaths(sharedContext(), fields, test::effectsOf(scene, fields), {}, rays);
    const double start = glm::length(glm::cross(rays[0].origin - lens.translate, rays[0].direction)) * 2.0 /
                         (1.0 + 0.3 * 0.3 / 0.64);
    int inside = 0;
    for (const TracePoint& point : points) {
        if (glm::length(point.at.position - lens.translate) > 0.7 * lens.scale || point.at.length > 1.5) continue;
        EXPECT_NEAR(ratioAt(point.at), start, 1e-3 * start);  // of trilinear interpolation at 46 voxels a unit
        ++inside;
    }
    EXPECT_GT(inside, 20);
}

TEST(Insets, AbsorbByBeerAndLambertWhicheverWayTheyLie) {
    const dvec3 sigma(1.0, 2.0, 4.0), size(0.5, 0.3, 0.4);
    Scene scene = sceneOf(8, {box(size, sigma)});
    scene.medium.absorption = quantity(dvec3(0.3));
    Object& object = scene.objects[0];
    object.rotate = {0.0, 0.0, 30.0};
    object.translate = {0.1, -0.05, 0.03};
    object.resolution = 64;
    const Fields fields = composeImageFields(scene);
    const dvec3 along(std::cos(glm::radians(30.0)), std::sin(glm::radians(30.0)), 0.0);
    const auto results = traced(scene, fields, {{object.translate - along * 5.0, along}});
    const double way = results[0].length;
    for (int band = 0; band < 3; ++band) {
        const double exact = sigma[band] * size.x + 0.3 * (way - size.x);
        // At each face samples of a ramp two voxels wide are three quarters of a voxel apart: off by a tenth of a voxel at most.
        EXPECT_NEAR(results[0].depth[band], exact, 0.2 * voxelOf(fields.insets[0]) * sigma[band]) << "band " << band;
    }
}

TEST(Insets, ShowWhatTheDomainIsTooCoarseFor) {
    Object sheet = box({0.5, 0.5, 0.02}, dvec3(0.0));
    sheet.opaque = true;
    Scene scene = sceneOf(16, {sheet});
    const std::vector<TraceRay> rays{{{0.03, 0.02, -3.0}, {0.0, 0.0, 1.0}}, {{0.4, 0.02, -3.0}, {0.0, 0.0, 1.0}}};
    EXPECT_EQ(traced(scene, composeFields(scene), rays)[0].status, TraceStatus::kExited) << "a sixth of a voxel of matter";
    scene.objects[0].resolution = 128;
    const Fields fields = composeImageFields(scene);
    const auto results = traced(scene, fields, rays);
    EXPECT_EQ(results[0].status, TraceStatus::kAbsorbed);
    EXPECT_NEAR(results[0].position.z, -0.01, 0.05 * voxelOf(fields.insets[0]));  // half coverage is linear in the place
    EXPECT_EQ(results[1].status, TraceStatus::kExited);
}

TEST(Insets, AreLaidOverEachOtherInTheScenesOrder) {
    Object large = glassSphere(0.6), small = glassSphere(0.3);
    large.absorption = quantity(dvec3(1.0));
    small.absorption = quantity(dvec3(3.0));
    small.ior = quantity(dvec3(1.3));
    for (Object* object : {&large, &small}) object->resolution = 80;
    const std::vector<TraceRay> rays{{{0.0, 0.0, -3.0}, {0.0, 0.0, 1.0}}};
    const auto through = [&](const Object& first, const Object& second) {
        const Scene scene = sceneOf(16, {first, second});
        return traced(scene, composeImageFields(scene), rays)[0];
    };
    const TraceResult smallWins = through(large, small), largeWins = through(small, large);
    const double slack = 2e-3;  // a fifth of a voxel at each of four faces, as for one box
    EXPECT_NEAR(smallWins.depth.x, 0.6 * 3.0 + 0.6 * 1.0, 3.0 * slack);
    EXPECT_NEAR(largeWins.depth.x, 1.2 * 1.0, slack);
    EXPECT_NEAR(smallWins.opticalLength, 2.0 + 0.6 * 0.3 + 0.6 * 0.5, slack);
    EXPECT_NEAR(largeWins.opticalLength, 2.0 + 1.2 * 0.5, slack);
}

TEST(Insets, AreSeenTheSameInFlightsAndStepByStep) {
    Object first = glassSphere(0.4), second = box({0.3, 0.4, 0.3}, {2.0, 1.0, 0.5});
    first.translate = {-0.4, 0.0, 0.0};
    second.translate = {0.5, 0.1, 0.0};
    second.rotate = {0.0, 40.0, 10.0};
    first.resolution = 64;
    second.resolution = 40;
    const Scene scene = sceneOf(24, {first, second});
    const Fields fields = composeImageFields(scene);
    const auto rays = parallelRays(0.9, 300, {0.2, 0.1, 1.0}, dvec3(0.0));
    const auto stepped = traced(scene, fields, rays, StraightFlights::kNone);
    const auto flown = traced(scene, fields, rays);
    double evaluations = 0.0, most = 0.0;
    std::vector<double> apart;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        apart.push_back(glm::length(flown[i].direction - stepped[i].direction));
        EXPECT_NEAR(flown[i].depth.x, stepped[i].depth.x, 0.4 * voxelOf(fields.insets[1]) * 2.0) << "ray " << i;
        evaluations += flown[i].evaluations;
        most += stepped[i].evaluations;
    }
    // Steps begin elsewhere: interpolation's own error for a radius of 25 voxels, of which one ray in twenty, at the rim, has more.
    std::sort(apart.begin(), apart.end());
    EXPECT_LE(apart[apart.size() * 19 / 20], 2.5e-3);
    EXPECT_LE(evaluations, 0.8 * most) << "the insides of both are crossed in one piece";
}

TEST(Insets, DisperseByTheirOwnConstant) {
    Object prism = box({0.5, 0.5, 0.5}, dvec3(0.0));
    prism.ior = quantity(dvec3(1.5));
    prism.rotate = {0.0, 20.0, 0.0};
    prism.resolution = 64;
    const double cauchyB = 0.01, wavelength = 0.45;
    Scene plain = sceneOf(16, {prism});
    plain.objects[0].ior = quantity(dvec3(f64::dispersedIndex(1.5, cauchyB, f64::dispersionTerm(wavelength))));
    Scene dispersing = sceneOf(16, {prism});
    dispersing.objects[0].cauchyB = cauchyB;
    const TraceRay ray{{0.05, 0.02, -3.0}, {0.0, 0.0, 1.0}};
    TraceRay blue = ray;
    blue.wavelengthMicrons = wavelength;
    const auto expected = traced(plain, composeImageFields(plain), {ray})[0];
    const auto found = traced(dispersing, composeImageFields(dispersing), {blue})[0];
    EXPECT_LE(glm::length(found.position - expected.position), 1e-5);  // rounding of n, as on aligned lattices
    EXPECT_NEAR(found.opticalLength, expected.opticalLength, 1e-5);
}

RenderResult rendered(const Scene& scene, const Fields& fields, const BakedLight* bake = nullptr,
                      const RenderOptions& options = {}) {
    return renderScene(sharedContext(), scene, fields, test::effectsOf(scene, fields), bake, options);
}

TEST(Insets, TransmitByFresnelsTerms) {
    Object slab = box({0.8, 0.8, 0.4}, dvec3(0.0));
    slab.ior = quantity(dvec3(1.5));
    slab.resolution = 96;
    Scene scene = sceneOf(12, {slab});
    scene.camera.fov = 0.5;
    scene.render.size = {3, 3};
    const RenderResult image = rendered(scene, composeImageFields(scene));
    const double reflectance = 0.04;  // ((1.5 - 1) / (1.5 + 1))²
    const double through = (1.0 - reflectance) * (1.0 - reflectance);
    // A band ends where 0.3 % of the contrast is left, on either side: 1.2 % of each reflectance.
    EXPECT_NEAR(image.channel("throughput.G").values[4], through, 1.5e-3);
    EXPECT_NEAR(image.radiance(1, 1).g, 1.0, 1e-5) << "and what is mirrored shows the sky of 1 too";
}

/// A ball of everything that matter can be, in a medium that it displaces.
Scene gallimaufry() {
    Object ball = glassSphere(0.5);
    ball.absorption = quantity({0.5, 1.0, 0.2});
    ball.scattering = quantity({0.4, 0.3, 0.6});
    ball.anisotropy = quantity(dvec3(0.5));
    ball.emission = quantity({0.05, 0.1, 0.2});
    ball.reflectionTint = {1.0, 0.5, 0.2};
    Object core = glassSphere(0.125);
    core.opaque = true;
    core.albedo = {0.7, 0.3, 0.1};
    Scene scene = sceneOf(64, {ball, core});
    scene.medium.scattering = quantity(dvec3(0.2));
    scene.medium.anisotropy = quantity(dvec3(0.2));
    return scene;
}

/// A scene whose objects have lattices of their own, against the same without.
void expectTheSame(Scene scene) {
    const Fields onDomain = composeFields(scene);
    const Lattice& lattice = onDomain.lattice;
    const BakedLight light{lattice, DenseGrid<glm::vec3>(lattice.size, glm::vec3(2.0f)),
                           DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.6f, 0.0f, 0.0f))};
    scene.objects[0].resolution = 32 + kPadding;
    scene.objects[1].resolution = 8 + 4;  // opaque: two voxels on each side
    const Fields withInsets = composeImageFields(scene);
    const RenderOptions stepping{.straightFlights = false};  // flights would move the places at which fields are looked at
    const RenderResult expected = rendered(scene, onDomain, &light, stepping);
    const RenderResult found = rendered(scene, withInsets, &light, stepping);
    double squares = 0.0, sum = 0.0;
    for (int y = 0; y < found.size.y; ++y)
        for (int x = 0; x < found.size.x; ++x) {
            const glm::vec3 difference = found.radiance(x, y) - expected.radiance(x, y);
            squares += double(glm::dot(difference, difference));
            sum += double(glm::dot(expected.radiance(x, y), glm::vec3(1.0f)));
        }
    const double pixels = double(found.size.x * found.size.y);
    // Rounding, and area coverage in 16 bits.
    EXPECT_LE(std::sqrt(squares / (3.0 * pixels)) / (sum / (3.0 * pixels)), 1e-4);
}

TEST(Insets, OfEveryKindOfMatterLookAsOnTheDomainsLattice) { expectTheSame(gallimaufry()); }

TEST(Insets, ScatterBandsOtherwiseAsOnTheDomainsLattice) {
    // What is mixed by scattering is no linear function of the coverage between voxels: contrasts of g as in the other scene.
    const Quantity byBand = quantity({0.5, 0.35, 0.2});
    const Quantity varying{.constant = dvec3(0.0), .expression = "0.35 + 0.2*x", .where = {}, .given = true};
    for (const auto& [ofMedium, ofBall] : {std::pair(quantity(dvec3(0.2)), byBand), std::pair(byBand, varying)}) {
        Scene scene = gallimaufry();
        scene.medium.anisotropy = ofMedium;
        scene.objects[0].anisotropy = ofBall;
        expectTheSame(scene);
    }
}

TEST(Insets, ThatMoveAreWhereTheyWouldHaveBeenComposed) {
    Scene scene = gallimaufry();
    scene.domain.resolution = 24;
    scene.objects[0].resolution = 40;
    scene.objects[1].resolution = 16;
    const StageFields before = composeStageFields(scene);
    ProgressiveImage image(sharedContext(), scene, *before.image.fields, before.image.effects, nullptr, {});
    scene.objects[0].translate = {0.2, -0.3, 0.1};
    scene.objects[0].rotate = {10.0, 70.0, -20.0};
    scene.objects[0].scale = 0.7;
    scene.objects[1].translate = {-0.4, 0.3, 0.2};
    const StageFields moved = movedStageFields(scene, before);
    EXPECT_EQ(moved.image.fields->insets[0].grids, before.image.fields->insets[0].grids) << "no grid is composed anew";
    image.moveInsets(*moved.image.fields);
    image.setFrame(scene.render.size, {{0, 0}, scene.render.size});
    while (!image.isComplete()) image.addRays(image.mostRays());
    const RenderResult composed = rendered(scene, composeImageFields(scene));
    for (std::size_t c = 0; c < composed.channels.size(); ++c)
        EXPECT_EQ(readImage(image).channels[c].values, composed.channels[c].values) << composed.channels[c].name;
}

TEST(Insets, ScatterForwardInADomainThatDoesNot) {
    Object smoke = box(dvec3(0.8), dvec3(0.0));
    smoke.scattering = quantity(dvec3(0.5));
    Scene scene = sceneOf(16, {smoke});
    const auto isIsotropic = [&] {
        const Fields fields = composeImageFields(scene);
        const auto defines = GpuFields(sharedContext(), fields, test::effectsOf(scene, fields)).defines();
        return std::count(defines.begin(), defines.end(), "ISOTROPIC_SCATTERING") == 1;
    };
    EXPECT_TRUE(isIsotropic());
    scene.objects[0].resolution = 16;
    EXPECT_TRUE(isIsotropic());
    scene.objects[0].anisotropy = quantity(dvec3(0.5));
    EXPECT_FALSE(isIsotropic());
}

TEST(Insets, CostScenesWithoutThemNothing) {
    Scene scene = gallimaufry();
    scene.domain.resolution = 16;
    const StageFields stages = composeStageFields(scene);
    EXPECT_EQ(stages.light.fields, stages.image.fields);
    const GpuFields without(sharedContext(), *stages.image.fields, stages.image.effects);
    const auto has = [](const GpuFields& fields, const std::string& define) {
        return std::count(fields.defines().begin(), fields.defines().end(), define) > 0;
    };
    EXPECT_FALSE(has(without, "INSETS"));
    scene.objects[1].resolution = 16;
    const Fields fields = composeImageFields(scene);
    const GpuFields with(sharedContext(), fields, test::effectsOf(scene, fields));
    EXPECT_TRUE(has(with, "INSETS"));
    EXPECT_EQ(with.textures().size(), without.textures().size() + 2);
}

} // namespace
} // namespace eikonal
