// Images against closed forms (docs/physics.md, sections 4 to 6).
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "common/physics.h"
#include "tests/support/synthetic_fields.h"
#include "viewer/render.h"

namespace eikonal {
namespace {

using test::sharedContext;

RenderResult rendered(const Scene& scene, const Fields& fields, const BakedLight* bake = nullptr,
                      const RenderOptions& options = {}) {
    return renderScene(sharedContext(), scene, fields, test::effectsOf(scene, fields), bake, options);
}

BakedLight constantLight(const Lattice& lattice, const glm::vec3& irradiance, const glm::vec3& direction) {
    return {lattice, DenseGrid<glm::vec3>(lattice.size, irradiance), DenseGrid<glm::vec3>(lattice.size, direction)};
}

void expectAll(const RenderResult& image, double value, double tolerance) {
    for (int y = 0; y < image.size.y; ++y) {
        for (int x = 0; x < image.size.x; ++x) {
            ASSERT_NEAR(image.radiance(x, y).g, value, tolerance) << "pixel " << x << ", " << y;
        }
    }
}

TEST(Render, AbsorbingSlabIsBeerLambertWhateverTheStep) {
    const Lattice lattice = test::cube(32, 1.0);
    Fields fields = test::uniformFields(lattice);
    const double thickness = 0.731;
    fields.sigmaA = test::boxGrid(lattice, {-1.0, -1.0, -0.413}, {1.0, 1.0, -0.413 + thickness}, {1.0f, 2.0f, 5.0f});
    for (const double stepVoxels : {0.5, 1.0, 2.0}) {
        Scene scene = test::plainScene(glm::dvec3(1.0), 30.0, 0.5, 3);
        scene.accuracy.stepVoxels = stepVoxels;
        const RenderResult image = rendered(scene, fields);
        EXPECT_NEAR(image.radiance(1, 1).r, std::exp(-thickness), 1e-3) << stepVoxels;
        EXPECT_NEAR(image.radiance(1, 1).g, std::exp(-2.0 * thickness), 1e-3) << stepVoxels;
        EXPECT_NEAR(image.radiance(1, 1).b, std::exp(-5.0 * thickness), 1e-3) << stepVoxels;
        EXPECT_NEAR(image.channel("depth.G").values[4], 2.0 * thickness, 1e-3);
    }
}

TEST(Render, WhiteFurnaceIsWhiteThroughGlass) {
    const Fields fields = test::sphereFields(test::cube(64, 1.0), 0.7, 1.5, 1.5 / 32.0);
    expectAll(rendered(test::plainScene(glm::dvec3(1.0), 4.0, 30.0, 48), fields), 1.0, 5e-3);
}

TEST(Render, CameraInsideGlassReadsTheSquareOfTheIndex) {
    const Fields fields = test::sphereFields(test::cube(64, 1.0), 0.7, 1.5, 1.5 / 32.0);
    expectAll(rendered(test::plainScene(glm::dvec3(1.0), 0.0, 60.0, 16), fields), 2.25, 0.0225);
}

TEST(Render, FresnelDimsTheMiddleOfASphereByTwoCrossings) {
    Fields fields = test::sphereFields(test::cube(64, 1.0), 0.7, 1.5, 1.5 / 32.0);
    const Scene scene = test::plainScene(glm::dvec3(1.0), 30.0, 0.2, 1);
    const RenderResult image = rendered(scene, fields);
    // The indices of a crossing are those of the last samples beside the band, a few 1e-3 off the glass's own.
    EXPECT_NEAR(image.channel("throughput.G").values[0], 0.96 * 0.96, 3e-3);
}

TEST(Render, FresnelOfASphereDependsOnTheImpactAlone) {
    const double radius = 0.7;
    Fields fields = test::sphereFields(test::cube(64, 1.0), radius, 1.5, 1.5 / 32.0);
    Scene scene = test::plainScene(glm::dvec3(1.0), 30.0, 1e-3, 1);
    for (const double impact : {0.5, 0.7, 0.85, 0.9}) {  // over the radius
        const f64::Polarised r = f64::fresnelReflectance(1.0, 1.5, impact);
        const double exact = 0.5 * ((1.0 - r.s) * (1.0 - r.s) + (1.0 - r.p) * (1.0 - r.p));
        double least = 1.0, most = 0.0;
        for (int i = 0; i < 24; ++i) {
            const double angle = 0.26 * i;
            const glm::dvec3 offset = impact * radius * glm::dvec3(std::cos(angle), std::sin(angle), 0.0);
            scene.camera.position = offset + glm::dvec3(0.0, 0.0, 30.0);
            scene.camera.lookAt = offset;
            const double throughput = rendered(scene, fields).channel("throughput.G").values[0];
            least = std::min(least, throughput);
            most = std::max(most, throughput);
        }
        // the boundary is a fifteenth of the radius wide, and flat angles feel that most: 0.008 at 0.9
        EXPECT_NEAR(0.5 * (least + most), exact, 0.01) << impact;
        // what voxels leave of the symmetry; by the steepest sample alone it would be 0.01 at 0.85 and 0.036 at 0.9
        EXPECT_LE(most - least, 0.004) << impact;
    }
}

TEST(Render, RaysThatGrazeABoundaryLoseNothing) {
    const double radius = 0.6, width = 1.5 / 32.0;
    const Fields fields = test::sphereFields(test::cube(64, 1.0), radius, 1.5, width);
    Scene scene = test::plainScene(glm::dvec3(1.0), 30.0, 1e-3, 1);
    for (const double impact : {radius + 2.2 * width, radius + 2.6 * width, radius + 3.0 * width}) {
        for (const double angle : {0.1, 0.8, 2.0, 4.0}) {
            const glm::dvec3 offset(impact * std::cos(angle), impact * std::sin(angle), 0.0);
            scene.camera.position = offset + glm::dvec3(0.0, 0.0, 30.0);
            scene.camera.lookAt = offset;
            EXPECT_GT(rendered(scene, fields).channel("throughput.G").values[0], 0.97f) << impact << ", " << angle;
        }
    }
}

TEST(Render, AWallThinnerThanItsBandsReflectsTwice) {
    const Lattice lattice = test::cube(64, 1.0);
    const double width = 1.5 / 32.0, half = 0.1;
    const auto step = [&](double d) { return 0.5 * std::erfc(d / (std::sqrt(2.0) * width)); };
    Fields fields =
        test::indexFields(lattice, [&](const glm::dvec3& x) { return 1.0 + 0.5 * step(std::abs(x.z) - half); });
    fields.interface = DenseGrid<unsigned char>(lattice.size, 255);
    const RenderResult image = rendered(test::plainScene(glm::dvec3(1.0), 30.0, 0.2, 1), fields);
    EXPECT_NEAR(image.channel("throughput.G").values[0], 0.96 * 0.96, 8e-3);
    EXPECT_NEAR(image.radiance(0, 0).g, 1.0, 1e-3);
}

/// A latitude-longitude map of 16 x 8 texels, dark but for the column of texels around u = 0.25 above the horizon.
std::filesystem::path writeMap() {
    const auto path = std::filesystem::temp_directory_path() / ("eikonal_map_" + std::to_string(std::rand()) + ".hdr");
    std::ofstream file(path, std::ios::binary);
    file << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n";
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 16; ++x) {
            const bool bright = (x == 3 || x == 4) && y < 4;
            const std::string texel = bright ? std::string("\x80\x40\x20\x81", 4) : std::string(4, '\0');
            file << texel;
        }
    }
    return path;
}

TEST(Render, EnvironmentMapIsSeenWhereOpenExrPutsIt) {
    Scene scene = test::plainScene(glm::dvec3(0.0), 4.0, 1.0, 1);
    scene.environment.image = writeMap();
    scene.environment.intensity = 2.0;
    const Fields fields = test::uniformFields(test::cube(1, 1e-3));
    const auto towards = [&](const glm::dvec3& direction, double rotate) {
        scene.camera.lookAt = scene.camera.position + direction;
        scene.environment.rotate = rotate;
        return rendered(scene, fields).radiance(0, 0);
    };
    EXPECT_NEAR(towards({1.0, 0.5, 0.0}, 0.0).r, 2.0, 1e-3);
    EXPECT_NEAR(towards({1.0, 0.5, 0.0}, 0.0).b, 0.5, 1e-3);
    EXPECT_NEAR(towards({1.0, -0.5, 0.0}, 0.0).r, 0.0, 1e-3);
    EXPECT_NEAR(towards({0.0, 0.5, 1.0}, 0.0).r, 0.0, 1e-3);
    EXPECT_NEAR(towards({0.0, 0.5, -1.0}, 90.0).r, 2.0, 1e-3) << "a turn about +Y takes +X to -Z";
    scene.render.effects = std::vector<std::string>{"refraction"};
    EXPECT_EQ(towards({1.0, 0.5, 0.0}, 0.0).r, 0.0f) << "no environment: nothing to see";
    std::filesystem::remove(*scene.environment.image);
}

TEST(Render, ScatteringSlabAgreesWithTheClosedForm) {
    const Lattice lattice = test::cube(32, 1.0);
    const double thickness = 0.8, sigma = 1.5, g = 0.4;
    Fields fields = test::uniformFields(lattice);
    fields.sigmaS = test::boxGrid(lattice, {-1.0, -1.0, -0.4}, {1.0, 1.0, 0.4}, glm::vec3(float(sigma)));
    fields.anisotropy = DenseGrid<float>(lattice.size, float(g));
    const glm::dvec3 light = glm::normalize(glm::dvec3(1.0, 0.0, 0.5));
    const BakedLight bake = constantLight(lattice, glm::vec3(3.0f), glm::vec3(light));
    const RenderResult image = rendered(test::plainScene(glm::dvec3(0.0), 30.0, 0.5, 1), fields, &bake);
    const double phase = f64::henyeyGreenstein(light.z, g);  // towards the camera on +Z
    const double exact = 3.0 * phase * (1.0 - std::exp(-sigma * thickness));
    EXPECT_NEAR(image.radiance(0, 0).g, exact, 0.02 * exact);
}

TEST(Render, CrossingBeamsInFogAgreeWithTheClosedForm) {
    const Lattice lattice = test::cube(32, 1.0);
    const double thickness = 0.8, sigma = 1.5, g = 0.7;
    Fields fields = test::uniformFields(lattice);
    fields.sigmaS = test::boxGrid(lattice, {-1.0, -1.0, -0.4}, {1.0, 1.0, 0.4}, glm::vec3(float(sigma)));
    fields.anisotropy = DenseGrid<float>(lattice.size, float(g));
    const glm::dvec3 first = glm::normalize(glm::dvec3(1.0, 0.0, 0.8)), second = glm::normalize(glm::dvec3(-1.0, 0.3, 0.2));
    BakedLight bake = constantLight(lattice, glm::vec3(3.0f), glm::vec3((2.0 * first + second) / 3.0));
    const Scene scene = test::plainScene(glm::dvec3(0.0), 30.0, 0.5, 1);
    const double ofMean = rendered(scene, fields, &bake).radiance(0, 0).g;
    for (std::uint32_t voxel = 0; voxel < lattice.count(); ++voxel) {
        bake.lobes.voxels.push_back(voxel);
        bake.lobes.rows.push_back(
            {LightLobe{glm::vec3(2.0f), glm::vec3(first)}, LightLobe{glm::vec3(1.0f), glm::vec3(second)}});
    }
    const double exact = (2.0 * f64::henyeyGreenstein(first.z, g) + f64::henyeyGreenstein(second.z, g)) *
                         (1.0 - std::exp(-sigma * thickness));
    const RenderResult image = rendered(scene, fields, &bake);
    EXPECT_NEAR(image.radiance(0, 0).g, exact, 0.02 * exact);  // as much as a slab under one beam
    EXPECT_GT(std::abs(ofMean - exact), 0.2 * exact);          // one direction in place of two is that far off
    const auto& textures = image.statistics.textures;
    EXPECT_TRUE(std::any_of(textures.begin(), textures.end(), [](const auto& row) { return row.first == "lobes"; }));
}

TEST(Render, LightScatteredInGlassIsDimmerByTheSquareOfTheIndex) {
    const Lattice lattice = test::cube(64, 1.0);
    const double n = 1.5;
    Fields matched = test::uniformFields(lattice);
    Fields unmatched = test::sphereFields(lattice, 0.7, n, 1.5 / 32.0);
    unmatched.interface = {};
    const auto column = test::boxGrid(lattice, {-0.2, -0.2, -0.2}, {0.2, 0.2, 0.2}, glm::vec3(1.0f));
    const DenseGrid<float> isotropic(lattice.size, 0.0f);
    for (Fields* fields : {&matched, &unmatched}) {
        fields->sigmaS = column;
        fields->anisotropy = isotropic;
    }
    const BakedLight bake = constantLight(lattice, glm::vec3(1.0f), glm::vec3(0.0f));
    const Scene scene = test::plainScene(glm::dvec3(0.0), 30.0, 0.1, 1);
    const double inAir = rendered(scene, matched, &bake).radiance(0, 0).g;
    const double inGlass = rendered(scene, unmatched, &bake).radiance(0, 0).g;
    EXPECT_NEAR(inAir / inGlass, n * n, 0.01 * n * n);
}

TEST(Render, IndexOneEqualsTheBackgroundExactly) {
    Scene scene = test::plainScene(glm::dvec3(0.0), 4.0, 40.0, 32);
    scene.environment.gradient = {glm::dvec3(0.9, 0.5, 0.2), glm::dvec3(0.1, 0.3, 0.8)};
    scene.camera.up = {0.3, 1.0, 0.0};
    const RenderResult filled =
        rendered(scene, test::indexFields(test::cube(32, 1.0), [](const glm::dvec3&) { return 1.0; }));
    const RenderResult empty = rendered(scene, test::uniformFields(test::cube(1, 1e-3)));
    for (int c = 0; c < 3; ++c) EXPECT_EQ(filled.channels[std::size_t(c)].values, empty.channels[std::size_t(c)].values);
}

TEST(Render, SlicesAndTilesChangeNoBit) {
    Fields fields = test::sphereFields(test::cube(32, 1.0), 0.7, 1.5, 1.5 / 16.0);
    fields.sigmaA = test::boxGrid(fields.lattice, glm::dvec3(-0.3), glm::dvec3(0.3), {0.2f, 1.0f, 2.0f});
    Scene scene = test::plainScene(glm::dvec3(1.0), 4.0, 40.0, 40);
    scene.environment.gradient = {glm::dvec3(0.9, 0.5, 0.2), glm::dvec3(0.1, 0.3, 0.8)};
    scene.render.samples = 3;
    const RenderResult whole = rendered(scene, fields);
    const RenderResult pieces = rendered(scene, fields, nullptr, {.stepsPerSlice = 7, .tileRays = 100});
    for (std::size_t c = 0; c < whole.channels.size(); ++c) {
        EXPECT_EQ(whole.channels[c].values, pieces.channels[c].values) << whole.channels[c].name;
    }
    EXPECT_EQ(whole.statistics.fieldEvaluations, pieces.statistics.fieldEvaluations);
    EXPECT_EQ(whole.statistics.rays, 40u * 40u * 3u);
}

TEST(Render, TrappedRaysEndAtTheLimitWithABackground) {
    const Fields fields = test::sphereFields(test::cube(32, 1.0), 0.7, 1.5, 1.5 / 16.0);
    Fields smoky = fields;
    smoky.sigmaA = DenseGrid<glm::vec3>(fields.lattice.size, glm::vec3(0.1f));
    // one or two are gone with the looks ahead of a flight, before the first step
    for (const std::uint32_t most : {1u, 2u, 3u, 10u}) {
        for (const Fields& passed : {fields, smoky}) {
            const RenderResult image =
                rendered(test::plainScene(glm::dvec3(1.0), 4.0, 30.0, 8), passed, nullptr, {.maxEvaluations = most});
            for (const float steps : image.channel("steps").values) EXPECT_LE(steps, float(most));
            for (int i = 0; i < 8; ++i) EXPECT_GT(image.radiance(i, i).r, 0.5f) << most;
        }
    }
}

TEST(Render, OpaqueSurfaceShowsItsIrradiance) {
    const Lattice lattice = test::cube(32, 1.0);
    Fields fields = test::uniformFields(lattice);
    fields.opaque = test::boxCoverage(lattice, {-0.8, -0.8, -0.8}, {0.8, 0.8, 0.1});
    fields.albedo = DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.5f, 0.25f, 1.0f));
    const BakedLight bake = constantLight(lattice, glm::vec3(2.0f), glm::vec3(0.0f, 0.6f, -0.8f));
    const RenderResult lit = rendered(test::plainScene(glm::dvec3(0.0), 30.0, 0.5, 1), fields, &bake);
    EXPECT_NEAR(lit.radiance(0, 0).r, 0.5 / 3.14159265 * 2.0 * 0.8, 1e-3);
    EXPECT_NEAR(lit.channel("N.Z").values[0], 1.0, 1e-6);
    EXPECT_NEAR(lit.channel("N.X").values[0], 0.0, 1e-6);
    const RenderResult ambient = rendered(test::plainScene(glm::dvec3(0.7), 30.0, 0.5, 1), fields);
    EXPECT_NEAR(ambient.radiance(0, 0).g, 0.25 * 0.7, 1e-3);
}

TEST(Render, EmissionGlowsAndAGradientLiesAround) {
    const Lattice lattice = test::cube(32, 1.0);
    Fields fields = test::uniformFields(lattice);
    fields.emission = test::boxGrid(lattice, {-1.0, -1.0, -0.5}, {1.0, 1.0, 0.5}, {2.0f, 1.0f, 0.5f});
    Scene scene = test::plainScene(glm::dvec3(0.25), 30.0, 0.5, 1);
    scene.accuracy.stepVoxels = 1.0;  // sums linear interpolation over a sharp face exactly
    const RenderResult image = rendered(scene, fields);
    EXPECT_NEAR(image.radiance(0, 0).r, 2.25, 2e-3);
    EXPECT_NEAR(image.radiance(0, 0).b, 0.75, 2e-3);
}

TEST(Render, EmptyImagesAndOneVoxelAreFine) {
    const Fields fields = test::uniformFields(test::cube(1, 1.0));
    EXPECT_TRUE(rendered(test::plainScene(glm::dvec3(1.0), 4.0, 30.0, 0), fields).display.empty());
    expectAll(rendered(test::plainScene(glm::dvec3(1.0), 4.0, 30.0, 5), fields), 1.0, 0.0);
}

} // namespace
} // namespace eikonal
