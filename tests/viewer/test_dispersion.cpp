// Dispersion along viewing rays: a prism's deviation by wavelength, white that stays white, rays that need no bands.
#include <cmath>

#include "common/scene_toml.h"
#include "common/spectrum.h"
#include "tests/support/synthetic_fields.h"
#include "viewer/render.h"
#include "viewer/trace.h"

namespace eikonal {
namespace {

constexpr double kHalfApex = 0.5235987755982988;  // of the equilateral prism [radians]

/// n(wavelength) = A + B/wavelength², with n_d at 0.5876 µm.
double cauchyIndex(double nD, double b, double micrometres) {
    return nD + b * (1.0 / (micrometres * micrometres) - 1.0 / (0.5876 * 0.5876));
}

/// A ray at the incidence at which a prism about the origin, corner up, deviates a wavelength least: inside it goes along x.
TraceRay raySymmetricAt(double n, double side, double height, double micrometres) {
    const double incidence = std::asin(n * std::sin(kHalfApex));
    const double upwards = incidence - kHalfApex;
    const glm::dvec3 direction(std::cos(upwards), std::sin(upwards), 0.0);
    const glm::dvec3 entry(-side / 3.0 + height * std::tan(kHalfApex), height, 0.0);
    return {entry - 1.5 * direction, direction, micrometres};
}

TEST(Prism, DeviatesEveryWavelengthByTheClosedForm) {
    const double nD = 1.5, b = 0.02, side = 1.2;
    const Scene scene = parseScene("[domain]\nmin = [-1, -0.8, -0.1]\nmax = [1, 0.8, 0.1]\nresolution = 128\n"
                                   "[[object]]\nshape = \"prism\"\nside = 1.2\nheight = 4\nior = 1.5\ncauchy_b = 0.02\n",
                                   "prism.toml", ".");
    const Fields fields = composeFields(scene);
    std::vector<TraceRay> rays;
    for (const double micrometres : {0.7, 0.6563, 0.5876, 0.4861, 0.4}) {
        for (const double height : {-0.07, -0.02, 0.03, 0.08, 0.13}) {
            rays.push_back(raySymmetricAt(cauchyIndex(nD, b, micrometres), side, height, micrometres));
        }
    }
    const auto results = traceRays(test::sharedContext(), fields, decideEffects(scene, fields), scene.accuracy, rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double n = cauchyIndex(nD, b, *rays[i].wavelengthMicrons);
        const double exact = 2.0 * std::asin(n * std::sin(kHalfApex)) - 2.0 * kHalfApex;  // δ = 2 asin(n sin(A/2)) - A
        const double found = std::acos(glm::dot(results[i].direction, glm::normalize(rays[i].direction)));
        // A smoothed plane boundary keeps n sin θ, so smoothing does not count; interpolation on voxels that the boundary
        // crosses obliquely does, by up to 1e-3 a boundary (RMS 4e-4 at 0.75 voxel a step, docs/performance.md). The
        // visible spectrum spans 0.13 rad.
        EXPECT_NEAR(found, exact, 2.5e-3) << 1e3 * *rays[i].wavelengthMicrons << " nm, ray " << i % 5;
    }
}

Fields sphere(int resolution, double cauchyB, double radius = 0.6) {
    const Lattice lattice = test::cube(resolution, 1.0);
    return test::dispersing(test::sphereFields(lattice, radius, 1.5, 1.5 * lattice.voxel), cauchyB, 1.5);
}

RenderResult rendered(const Scene& scene, const Fields& fields, const BakedLight* light = nullptr,
                      const RenderOptions& options = {}) {
    return renderScene(test::sharedContext(), scene, fields, test::effectsOf(scene, fields), light, options);
}

class WhiteStaysWhite : public ::testing::TestWithParam<int> {};

TEST_P(WhiteStaysWhite, ThroughADispersingSphere) {
    Fields fields = sphere(32, 0.05);
    fields.interface = {};  // no Fresnel terms
    Scene scene = test::plainScene(glm::dvec3(1.0), 4.0, 30.0, 24);
    scene.accuracy.bands = GetParam();
    const RenderResult image = rendered(scene, fields);
    for (int i = 0; i < 24 * 24; ++i) {
        const glm::vec3 radiance = image.radiance(i % 24, i / 24);
        for (int channel = 0; channel < 3; ++channel) {
            ASSERT_NEAR(radiance[channel], 1.0, 1e-3) << "pixel " << i % 24 << ", " << i / 24;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(InBands, WhiteStaysWhite, ::testing::Values(3, 8, 32),
                         [](const auto& bands) { return std::to_string(bands.param); });

TEST(DispersedImage, IsColouredWhereAnEdgeIsSeenThroughGlass) {
    Scene scene = test::plainScene(glm::dvec3(1.0), 4.0, 30.0, 24);
    scene.environment.gradient = {glm::dvec3(0.0), glm::dvec3(1.0)};
    scene.accuracy.bands = 8;
    Fields fields = sphere(32, 0.05);
    const auto mostColour = [&](const RenderResult& image) {
        double most = 0.0;
        for (int i = 0; i < 24 * 24; ++i) {
            const glm::vec3 radiance = image.radiance(i % 24, i / 24);
            most = std::max(most, double(std::abs(radiance.r - radiance.b)));
        }
        return most;
    };
    EXPECT_GT(mostColour(rendered(scene, fields)), 0.01);
    fields.cauchyB = {};
    EXPECT_EQ(mostColour(rendered(scene, fields)), 0.0);
}

TEST(DispersedImage, OnlyRaysThatMeetDispersionAreFollowedByBand) {
    Scene scene = test::plainScene(glm::dvec3(1.0), 4.0, 30.0, 24);
    scene.accuracy.bands = 10;
    Fields fields = sphere(64, 0.05, 0.3);
    const RenderOptions stepsOnly{.straightFlights = false};  // flights would go less far with dispersion
    const RenderResult dispersed = rendered(scene, fields, nullptr, stepsOnly);
    fields.cauchyB = {};
    const RenderResult plain = rendered(scene, fields, nullptr, stepsOnly);
    const double more = double(dispersed.statistics.fieldEvaluations) / double(plain.statistics.fieldEvaluations) - 1.0;
    // The tails of the sphere's boundary are above the rounding of n to a radius of 0.55, and differences reach three
    // voxels farther: of the image, which the domain fills, a third. In ten bands.
    EXPECT_NEAR(more, 0.33 * 10.0, 0.1 * 10.0);
    for (const char* name : {"exit.X", "depth.G", "steps", "optical_length", "throughput.B"}) {
        const auto &with = dispersed.channel(name).values, &without = plain.channel(name).values;
        ASSERT_EQ(with.size(), without.size());
        for (std::size_t i = 0; i < with.size(); ++i) {
            // other kernels, in which compilers may round other sums
            EXPECT_NEAR(with[i], without[i], 1e-5) << name << " is the reference wavelength's";
        }
    }
    EXPECT_EQ(dispersed.radiance(0, 12), plain.radiance(0, 12)) << "beside the sphere";
}

TEST(DispersedImage, TakesTheLightOfEveryBand) {
    const Lattice lattice = test::cube(16, 1.0);
    Fields fields = sphere(16, 0.05);
    fields.interface = {};
    fields.sigmaS = DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.5f, 0.4f, 0.2f));
    fields.anisotropy = DenseGrid<float>(lattice.size, 0.0f);
    Scene scene = test::plainScene(glm::dvec3(0.0), 4.0, 30.0, 8);
    scene.accuracy.bands = 5;
    const auto bands = spectralBands(5);
    BakedLight light{lattice, DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.0f)),
                     DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.0f))};
    for (std::size_t lit = 0; lit < bands.size(); ++lit) {
        light.bands.clear();
        for (std::size_t band = 0; band < bands.size(); ++band) {
            light.bands.push_back({bands[band].wavelengthNm(), DenseGrid<float>(lattice.size, band == lit ? 2.0f : 0.0f)});
        }
        const RenderResult image = rendered(scene, fields, &light);
        const glm::dvec3 colour = bands[lit].toRgb;
        for (int i = 0; i < 64; ++i) {
            const glm::dvec3 radiance(image.radiance(i % 8, i / 8));
            // of the band's own colour, to the rounding of floats
            EXPECT_LE(glm::length(glm::cross(radiance, colour)), 1e-5 * glm::length(radiance) * glm::length(colour) + 1e-9);
        }
        EXPECT_GT(glm::dot(glm::dvec3(image.radiance(4, 4)), colour), 0.0);
    }
}

TEST(DispersedTrace, WavelengthsOfAnInputKeepItsOrder) {
    const Fields fields = sphere(24, 0.05);
    const Scene scene;
    const EffectSet effects = test::effectsOf(scene, fields);
    const auto rayOf = [](std::optional<double> micrometres) {
        return TraceRay{{-2.0, 0.3, 0.1}, {1.0, 0.0, 0.0}, micrometres};
    };
    const std::vector<TraceRay> mixed{rayOf(0.45), rayOf({}), rayOf(0.65), rayOf(0.45)};
    const auto results = traceRays(test::sharedContext(), fields, effects, scene.accuracy, mixed);
    for (std::size_t i = 0; i < mixed.size(); ++i) {
        const auto alone = traceRays(test::sharedContext(), fields, effects, scene.accuracy, {mixed[i]});
        EXPECT_EQ(results[i].direction, alone[0].direction) << i;
    }
    EXPECT_LT(results[0].direction.y, results[1].direction.y) << "blue is bent more";
    EXPECT_LT(results[1].direction.y, results[2].direction.y);
    const auto points = tracePaths(test::sharedContext(), fields, effects, scene.accuracy, mixed);
    EXPECT_EQ(points.front().ray, 0u);
    EXPECT_EQ(points.back().ray, 3u);
    // paths are cut into slices of one step, which rounds some dozens of times more
    EXPECT_LT(glm::distance(points.back().at.direction, results[3].direction), 1e-6);
}

} // namespace
} // namespace eikonal
