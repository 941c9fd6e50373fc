// Camera rays: every pixel of a tile has one, whatever the order in which they are listed.
#include <algorithm>
#include <set>

#include "common/device_frame.h"
#include "common/gpu_fields.h"
#include "tests/support/synthetic_fields.h"
#include "viewer/generate.h"
#include "viewer/sampling.h"
#include "viewer/view.h"

namespace eikonal {
namespace {

using test::sharedContext;

/// Rays on the list, in its order, after those of a tile of a camera inside the domain were begun.
std::vector<gpu::uint> listedOf(const glm::ivec2& tile) {
    const Fields fields = test::indexFields(test::cube(8, 1.0), [](const glm::dvec3&) { return 1.2; });
    const EffectSet effects = test::effectsOf(Scene(), fields);
    GpuFields onDevice(sharedContext(), fields, effects, Interpolation::kLinear);
    viewer::RayBatch batch(sharedContext(), std::size_t(tile.x) * std::size_t(tile.y));
    const viewer::Generate generate(sharedContext(), onDevice.defines(), viewer::Generate::Source::kPinhole);
    const Scene scene = test::plainScene(glm::dvec3(0.0), 0.5, 40.0, 1000);
    viewer::configureCamera(batch.view, deviceFromWorld(fields.lattice, scene.camera), scene.render.size);
    viewer::configureTile(batch.view, {{3, 5}, tile}, 0);
    viewer::configureRound(batch.view, 0, {});
    batch.view.bandChannel = gpu::kAllChannels;
    onDevice.bind();
    batch.bind();
    generate.run(batch);
    return batch.lists.filledRays();
}

TEST(Generate, ListsEveryPixelOfATileOnce) {
    for (const glm::ivec2& tile : {glm::ivec2(1, 1), glm::ivec2(3, 2), glm::ivec2(64, 64), glm::ivec2(13, 101), glm::ivec2(257, 90)}) {
        const std::vector<gpu::uint> rays = listedOf(tile);
        const std::set<gpu::uint> different(rays.begin(), rays.end());
        const std::size_t pixels = std::size_t(tile.x) * std::size_t(tile.y);
        EXPECT_EQ(rays.size(), pixels);
        EXPECT_EQ(different.size(), pixels);
        EXPECT_TRUE(std::all_of(rays.begin(), rays.end(), [&](gpu::uint ray) { return ray < pixels; }));
    }
}

/// Of a list's stretch, the middle of its pixels as a share of the picture's height.
double middleHeight(const std::vector<gpu::uint>& rays, std::size_t first, std::size_t end, const glm::ivec2& tile) {
    double sum = 0.0;
    for (std::size_t i = first; i < end; ++i) sum += double(rays[i] / gpu::uint(tile.x));
    return sum / double(end - first) / double(tile.y);
}

TEST(Generate, ListsAnyPartOfATileFromAllOverIt) {
    const glm::ivec2 tile(256, 256);
    const std::vector<gpu::uint> rays = listedOf(tile);
    const std::size_t quarter = rays.size() / 4;
    for (std::size_t i = 0; i < 4; ++i) {
        // twenty-two of 89 pieces each, which lie evenly: a piece more or less at one end is a fiftieth
        EXPECT_NEAR(middleHeight(rays, i * quarter, (i + 1) * quarter, tile), 0.5, 0.03) << "quarter " << i;
    }
}

} // namespace
} // namespace eikonal
