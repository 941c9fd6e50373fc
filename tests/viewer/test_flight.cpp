// Straight flights against steps through everything: the same image and the same rays at a fraction of the work.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/scene_toml.h"
#include "tests/support/synthetic_fields.h"
#include "viewer/render.h"
#include "viewer/trace.h"

namespace eikonal {
namespace {

using test::sharedContext;

struct Comparison {
    RenderResult flown, stepped;

    /// RMS difference of radiance over all pixels but one in fifty. Rays that graze the ball or nearly do after reflections
    /// inside go one way or the other by less than any step is good to: those pixels differ by all they can.
    double rms() const {
        std::vector<double> squares;
        for (std::size_t i = 0; i < flown.display.size(); ++i) {
            glm::dvec3 error;
            for (int c = 0; c < 3; ++c)
                error[c] = flown.channels[std::size_t(c)].values[i] - stepped.channels[std::size_t(c)].values[i];
            squares.push_back(glm::dot(error, error) / 3.0);
        }
        std::sort(squares.begin(), squares.end());
        squares.resize(squares.size() - squares.size() / 50);
        return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0) / double(squares.size()));
    }
    double stepsSaved() const { return double(stepped.statistics.steps) / double(flown.statistics.steps); }
};

Comparison compared(const Scene& scene, const Fields& fields, const BakedLight* bake = nullptr) {
    const EffectSet effects = test::effectsOf(scene, fields);
    return {renderScene(sharedContext(), scene, fields, effects, bake),
            renderScene(sharedContext(), scene, fields, effects, bake, {.straightFlights = false})};
}

/// A ball whose edge takes up a small part of the domain, under a sky that is nowhere even.
Fields ballFields(int resolution) {
    return test::sphereFields(test::cube(resolution, 1.0), 0.4, 1.5, 1.5 * 2.0 / resolution);
}

Scene ballScene(int size) {
    Scene scene = test::plainScene(glm::dvec3(0.0), 4.0, 28.0, size);
    scene.environment.gradient = {glm::dvec3(0.9, 0.5, 0.2), glm::dvec3(0.1, 0.3, 0.8)};
    return scene;
}

TEST(Flight, RefractionLooksTheSameWithAFractionOfTheSteps) {
    const Comparison image = compared(ballScene(64), ballFields(96));
    // A step elsewhere relative to the voxels is as good: the integrator's own error at 0.75 voxel, times the sky's slope.
    EXPECT_LE(image.rms(), 1e-3);
    EXPECT_GE(image.stepsSaved(), 4.0);
    EXPECT_GT(image.flown.statistics.clearanceLookUps, 0u);
    EXPECT_EQ(image.stepped.statistics.clearanceLookUps, 0u);
}

TEST(Flight, CubicInterpolationLooksTheSameToo) {
    Scene scene = ballScene(64);
    scene.accuracy.interpolation = Interpolation::kCubic;
    const Comparison image = compared(scene, ballFields(96));
    EXPECT_LE(image.rms(), 1e-3);  // as with linear interpolation: splines of an erfc ring by less than a flight may ignore
    EXPECT_GE(image.stepsSaved(), 4.0);
}

TEST(Flight, MuseumTakesAQuarterOfTheSteps) {
    Scene scene = loadScene(std::string(EIKONAL_SCENES) + "/museum.toml", {"render.size=[96, 40]"});
    scene.environment.image.reset();
    scene.render.samples = 1;
    const Comparison image = compared(scene, composeFields(scene));
    EXPECT_LE(image.rms(), 1e-3);
    EXPECT_GE(image.stepsSaved(), 4.0);
}

TEST(Flight, EvenMatterIsPassedInOnePiece) {
    Fields fields = test::uniformFields(test::cube(64, 1.0));
    fields.sigmaA = DenseGrid<glm::vec3>(fields.lattice.size, glm::vec3(0.3f, 1.0f, 2.5f));
    fields.emission = DenseGrid<glm::vec3>(fields.lattice.size, glm::vec3(0.4f, 0.2f, 0.1f));
    const Comparison image = compared(test::plainScene(glm::dvec3(1.0), 30.0, 3.0, 8), fields);
    EXPECT_LE(image.rms(), 2e-6);  // both are exact for constants: rounding of some eighty steps is what differs
    EXPECT_LE(image.flown.statistics.steps, image.flown.statistics.rays);
}

/// Light that varies, and fog of it where `isFoggy` says.
template <class IsFoggy>
Comparison comparedInLitFog(const IsFoggy& isFoggy) {
    Fields fields = ballFields(64);
    fields.sigmaS = DenseGrid<glm::vec3>(fields.lattice.size, glm::vec3(0.0f));
    fields.anisotropy = DenseGrid<float>(fields.lattice.size, 0.3f);
    BakedLight bake{fields.lattice, DenseGrid<glm::vec3>(fields.lattice.size, glm::vec3(0.0f)),
                    DenseGrid<glm::vec3>(fields.lattice.size, glm::vec3(0.0f, -1.0f, 0.0f))};
    test::forEachVoxel(fields.lattice, [&](const glm::ivec3& v) {
        const glm::dvec3 x = fields.lattice.worldFromIndex(v);
        bake.irradiance.at(v) = glm::vec3(float(1.0 + std::cos(40.0 * x.x) * std::sin(30.0 * x.z)));  // a wave of 5 voxels
        if (isFoggy(x)) fields.sigmaS.at(v) = glm::vec3(0.5f);
    });
    return compared(ballScene(48), fields, &bake);
}

TEST(Flight, LitFogIsPassedStepByStep) {
    const Comparison all = comparedInLitFog([](const glm::dvec3&) { return true; });
    EXPECT_EQ(all.flown.statistics.clearanceLookUps, 0u);
    EXPECT_EQ(all.flown.statistics.steps, all.stepped.statistics.steps);
    EXPECT_EQ(all.rms(), 0.0);
    const Comparison half = comparedInLitFog([](const glm::dvec3& x) { return x.z < 0.0; });
    EXPECT_LE(half.rms(), 1e-3);
    EXPECT_GE(half.stepsSaved(), 1.3);  // by those in the other half, as far as they do not pass the ball's edge
    EXPECT_GT(half.flown.statistics.clearanceLookUps, 0u);
}

TEST(Flight, OpaqueMatterIsMetWhereItIs) {
    Fields fields = ballFields(64);
    fields.opaque = test::boxCoverage(fields.lattice, {-1.0, -1.0, -0.8}, {1.0, -0.61, 0.9});
    fields.albedo = DenseGrid<glm::vec3>(fields.lattice.size, glm::vec3(0.2f, 0.5f, 0.7f));
    Scene scene = ballScene(48);
    scene.camera.position.y = 1.0;
    scene.camera.lookAt = {0.0, -0.2, 0.0};
    const Comparison image = compared(scene, fields);
    EXPECT_LE(image.rms(), 1e-3);
    EXPECT_GE(image.stepsSaved(), 1.5);  // half the rays end on the floor, and step towards it
}

TEST(Flight, MatterInsideGlassIsAttenuatedExactly) {
    Fields fields = ballFields(64);
    fields.sigmaA = DenseGrid<glm::vec3>(fields.lattice.size, glm::vec3(0.0f));
    test::forEachVoxel(fields.lattice, [&](const glm::ivec3& v) {
        const double share = test::sphereCoverage(fields.lattice, v, 0.4);
        fields.sigmaA.at(v) = glm::vec3(1.0f, 3.0f, 0.5f) * float(share);
    });
    const Comparison image = compared(ballScene(48), fields);
    EXPECT_LE(image.rms(), 1e-3);
    EXPECT_GE(image.stepsSaved(), 2.5);
}

TEST(Flight, DispersionLooksTheSameWithAFractionOfTheSteps) {
    Scene scene = ballScene(48);
    scene.accuracy.bands = 4;
    const Comparison image = compared(scene, test::dispersing(ballFields(64), 0.03, 1.5));
    EXPECT_LE(image.rms(), 1e-3);
    EXPECT_GE(image.stepsSaved(), 1.5);  // those that are followed by band go through the ball, where they step
}

TEST(Flight, IsNotTakenWhereOnlyOtherWavelengthsAreBent) {
    const Lattice lattice = test::cube(64, 1.0);
    Fields fields = test::indexFields(lattice, [](const glm::dvec3&) { return 1.5; });
    fields.cauchyB = test::indexFields(lattice, [](const glm::dvec3& x) {
                         return 0.02 * std::exp(-50.0 * glm::dot(x, x));
                     }).ior;
    fields.cauchyGradient = gradientOf(fields.cauchyB, lattice.voxel);
    const EffectSet effects = test::effectsOf(Scene(), fields);
    const std::vector<TraceRay> blue = {{{-2.0, 0.1, 0.0}, {1.0, 0.0, 0.0}, 0.45}};
    const TraceResult flown = traceRays(sharedContext(), fields, effects, Accuracy(), blue).front();
    const TraceResult stepped =
        traceRays(sharedContext(), fields, effects, Accuracy(), blue, StraightFlights::kNone).front();
    // Along y = 0.1 the integral of dn/dy is -10 exp(-1/2) 0.0408 sqrt(pi/50) = -0.062: over n, an angle of -0.041. To second
    // order the ray comes nearer the middle, where it is bent less.
    EXPECT_NEAR(flown.direction.y, -0.041, 0.004);
    EXPECT_NEAR(flown.direction.y, stepped.direction.y, 1e-4);  // the same steps elsewhere relative to the voxels
    EXPECT_LT(flown.evaluations, stepped.evaluations);
}

TEST(Flight, NothingIsUploadedWhereNoRayCanFly) {
    const Fields fields = test::indexFields(test::cube(16, 1.0), [](const glm::dvec3& x) { return 1.2 + 0.1 * x.y; });
    const RenderResult image =
        renderScene(sharedContext(), ballScene(8), fields, test::effectsOf(ballScene(8), fields), nullptr);
    for (const auto& [name, bytes] : image.statistics.textures) EXPECT_NE(name, "clearance");
    EXPECT_EQ(image.statistics.clearanceLookUps, 0u);
}

TEST(Flight, RaysPastEverythingTakeOneFlight) {
    const Fields fields = ballFields(64);
    const std::vector<TraceRay> rays = {{{0.8, 0.8, -3.0}, {0.0, 0.0, 1.0}}, {{0.8, 0.1, 0.2}, {1.0, 0.0, 0.0}}};
    const Scene scene;
    const auto paths =
        tracePaths(sharedContext(), fields, test::effectsOf(scene, fields), scene.accuracy, rays);
    ASSERT_EQ(paths.size(), 4u);  // for each ray its entry and its exit
    EXPECT_EQ(paths[1].at.position, glm::dvec3(glm::vec3(0.8f, 0.8f, 1.0f)));
    EXPECT_NEAR(paths[1].at.opticalLength, 2.0, 1e-6);
    EXPECT_EQ(paths[1].at.evaluations, 1u);  // where it enters
    EXPECT_NEAR(paths[3].at.length, 0.2, 1e-6);
}

TEST(Flight, RaysEndWhereStepsThroughEverythingEnd) {
    const Fields fields = ballFields(96);
    std::vector<TraceRay> rays;
    for (int i = 0; i < 200; ++i) {
        const double r = 0.38 * std::sqrt((i + 0.5) / 200.0), angle = 2.399963229728653 * i;
        rays.push_back({{r * std::cos(angle), r * std::sin(angle), -3.0}, {0.02, -0.01, 1.0}});
    }
    const EffectSet effects = test::effectsOf(Scene(), fields);
    Accuracy fine;
    fine.stepVoxels = 0.25;
    const auto exact = traceRays(sharedContext(), fields, effects, fine, rays, StraightFlights::kNone);
    const auto rmsAgainst = [&](StraightFlights flights) {
        const auto results = traceRays(sharedContext(), fields, effects, Accuracy(), rays, flights);
        double squares = 0.0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const glm::dvec3 error = results[i].direction - exact[i].direction;
            squares += glm::dot(error, error) / double(rays.size());
        }
        return std::sqrt(squares);
    };
    // Flights leave out what bends a ray by nothing: no less accurate than the same steps throughout, but for chance.
    EXPECT_LE(rmsAgainst(StraightFlights::kTaken), 1.25 * rmsAgainst(StraightFlights::kNone));
}

} // namespace
} // namespace eikonal
