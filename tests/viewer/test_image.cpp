// A progressive image is the still that renderScene makes, however it came about.
#include "tests/support/synthetic_fields.h"
#include "viewer/portions.h"
#include "viewer/render.h"

namespace eikonal {
namespace {

Scene ballScene() {
    Scene scene = test::plainScene(glm::dvec3(1.0), 4.0, 40.0, 24);
    scene.render.size = {31, 17};  // prime, so that pieces of rows and of samples never fit
    scene.environment.gradient = {glm::dvec3(0.9, 0.5, 0.2), glm::dvec3(0.1, 0.3, 0.8)};
    scene.render.samples = 2;
    return scene;
}

void expectSameChannels(const RenderResult& a, const RenderResult& b) {
    ASSERT_EQ(a.channels.size(), b.channels.size());
    for (std::size_t c = 0; c < a.channels.size(); ++c) EXPECT_EQ(a.channels[c].values, b.channels[c].values);
    EXPECT_EQ(a.display, b.display);
}

/// Samples of the whole frame, in portions of so many rays.
void complete(ProgressiveImage& image, const Scene& scene, std::size_t portion) {
    image.setFrame(scene.render.size, {{0, 0}, scene.render.size});
    while (image.rounds() < scene.render.samples) image.addRays(portion);
}

TEST(ProgressiveImage, EqualsTheStillAfterAnyHistory) {
    const Fields fields = test::sphereFields(test::cube(32, 1.0), 0.7, 1.5, 1.5 / 16.0);
    const Scene scene = ballScene();
    const EffectSet effects = test::effectsOf(scene, fields);
    const RenderResult still = renderScene(test::sharedContext(), scene, fields, effects, nullptr);

    Scene other = scene;
    other.camera.position = {3.0, 1.0, -2.0};
    other.render.size = {9, 7};
    ProgressiveImage image(test::sharedContext(), other, fields, effects, nullptr, {.tileRays = 50});
    image.setStep(2.0);
    complete(image, other, 20);
    other.camera.aperture = 0.3;
    image.setCamera(other.camera);
    complete(image, other, 40);
    image.setStep(0.75);
    image.setCamera(scene.camera);
    complete(image, scene, 13);
    EXPECT_DOUBLE_EQ(image.roundProgress(), 0.0);
    expectSameChannels(readImage(image), still);
}

TEST(ProgressiveImage, IsTheSameInThePortionsOfAGpu) {
    const Fields fields = test::sphereFields(test::cube(32, 1.0), 0.7, 1.5, 1.5 / 16.0);
    Scene scene = ballScene();
    scene.accuracy.reflections = 2;  // rays that stay inside for long
    const EffectSet effects = test::effectsOf(scene, fields);
    const RenderResult usual = renderScene(test::sharedContext(), scene, fields, effects, nullptr);
    {
        const gpu::Context hardware = gpu::Context::windowless({.asHardware = true});
        expectSameChannels(renderScene(hardware, scene, fields, effects, nullptr), usual);
    }
    test::sharedContext().makeCurrent();
}

TEST(Portions, FitStorageBlocks) {
    for (const std::size_t block : {std::size_t(128) << 20, std::size_t(2) << 30}) {  // the least that is asked for, and a GPU's
        const viewer::Portions ofGpu = viewer::portionsFor({.maxStorageBlockBytes = block});
        EXPECT_LE(ofGpu.rays * sizeof(gpu::PixelReflections), block);
        EXPECT_LE(ofGpu.rays * sizeof(gpu::RayState), block);
        EXPECT_LE(ofGpu.rays, ofGpu.stepsOfDispatch) << "every ray makes a step";
        EXPECT_GT(ofGpu.rays, viewer::portionsFor({.maxStorageBlockBytes = block, .isProcessor = true}).rays);
    }
}

TEST(ProgressiveImage, WithDispersionEqualsTheStillInAnyPortions) {
    const Fields fields = test::dispersing(test::sphereFields(test::cube(16, 1.0), 0.7, 1.5, 1.5 / 8.0), 0.03, 1.5);
    Scene scene = ballScene();
    scene.accuracy.bands = 4;
    const EffectSet effects = test::effectsOf(scene, fields);
    const RenderResult still = renderScene(test::sharedContext(), scene, fields, effects, nullptr);
    ProgressiveImage image(test::sharedContext(), scene, fields, effects, nullptr, {.tileRays = 50});
    complete(image, scene, 13);
    expectSameChannels(readImage(image), still);
}

TEST(ProgressiveImage, HoldsTheMeanAfterEverySample) {
    const Fields fields = test::sphereFields(test::cube(16, 1.0), 0.7, 1.5, 1.5 / 8.0);
    Scene scene = ballScene();
    const EffectSet effects = test::effectsOf(scene, fields);
    ProgressiveImage image(test::sharedContext(), scene, fields, effects, nullptr, {});
    for (scene.render.samples = 1; scene.render.samples <= 3; ++scene.render.samples) {
        complete(image, scene, 1u << 17);
        expectSameChannels(readImage(image), renderScene(test::sharedContext(), scene, fields, effects, nullptr));
    }
}

TEST(ProgressiveImage, TakesAnotherLight) {
    const Lattice lattice = test::cube(16, 1.0);
    Fields fields = test::uniformFields(lattice);
    fields.sigmaS = DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.5f));
    fields.anisotropy = DenseGrid<float>(lattice.size, 0.0f);
    const Lattice coarse = test::cube(4, 1.0);
    const auto light = [](const Lattice& on, float irradiance) {
        return BakedLight{on, {on.size, glm::vec3(irradiance)}, {on.size, glm::vec3(0.0f)}};
    };
    const Scene scene = ballScene();
    const EffectSet effects = test::effectsOf(scene, fields);
    const BakedLight dark = light(coarse, 0.0f), bright = light(lattice, 3.0f);
    ProgressiveImage image(test::sharedContext(), scene, fields, effects, &dark, {});
    image.setLight(bright);
    complete(image, scene, 1u << 17);
    expectSameChannels(readImage(image), renderScene(test::sharedContext(), scene, fields, effects, &bright));
}

TEST(NextTile, CoversARegionOnceInOrder) {
    const viewer::Tile region{{3, 5}, {7, 4}};
    for (const std::size_t most : {1u, 3u, 7u, 10u, 15u, 100u}) {
        std::size_t done = 0;
        while (done < region.pixels()) {
            const viewer::Tile tile = viewer::nextTile(region, done, most);
            ASSERT_GE(tile.pixels(), 1u);
            ASSERT_LE(tile.pixels(), most);
            // The film is row after row: a tile must be a run of it.
            ASSERT_TRUE(tile.size.y == 1 || tile.size.x == region.size.x);
            ASSERT_EQ((tile.origin.y - 5) * 7 + tile.origin.x - 3, int(done));
            done += tile.pixels();
        }
        ASSERT_EQ(done, region.pixels());
    }
}

} // namespace
} // namespace eikonal
