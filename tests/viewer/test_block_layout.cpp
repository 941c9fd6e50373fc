// Both languages lay out the structs that the viewer's stages share alike.
#include <array>
#include <bit>
#include <cstring>
#include <numeric>

#include "shaders/shared/domain_block.h"
#include "shaders/shared/inset_blocks.h"
#include "shaders/shared/look_block.h"
#include "shaders/shared/reflection_blocks.h"
#include "shaders/shared/view_blocks.h"
#include "tests/support/block_layout.h"
#include "tests/support/synthetic_fields.h"

namespace eikonal::gpu {

using glm::floatBitsToUint;
using glm::uintBitsToFloat;
using glm::uvec3;
using glm::uvec4;
#include "shaders/viewer/ray_rows.glsl"

} // namespace eikonal::gpu

namespace eikonal {
namespace {

test::Members viewBlockMembers() {
    return {
        EIKONAL_MEMBER(gpu::ViewBlock, cameraPosition), EIKONAL_MEMBER(gpu::ViewBlock, stepLength),
        EIKONAL_MEMBER(gpu::ViewBlock, cameraRight), EIKONAL_MEMBER(gpu::ViewBlock, minThroughput),
        EIKONAL_MEMBER(gpu::ViewBlock, cameraUp), EIKONAL_MEMBER(gpu::ViewBlock, environmentAngle),
        EIKONAL_MEMBER(gpu::ViewBlock, cameraForward), EIKONAL_MEMBER(gpu::ViewBlock, environmentScale),
        EIKONAL_MEMBER(gpu::ViewBlock, horizon), EIKONAL_MEMBER(gpu::ViewBlock, rayCount),
        EIKONAL_MEMBER(gpu::ViewBlock, zenith), EIKONAL_MEMBER(gpu::ViewBlock, stepsPerSlice),
        EIKONAL_MEMBER(gpu::ViewBlock, lightMin), EIKONAL_MEMBER(gpu::ViewBlock, maxEvaluations),
        EIKONAL_MEMBER(gpu::ViewBlock, lightScale), EIKONAL_MEMBER(gpu::ViewBlock, opaqueOffset),
        EIKONAL_MEMBER(gpu::ViewBlock, imageSize), EIKONAL_MEMBER(gpu::ViewBlock, tileOrigin),
        EIKONAL_MEMBER(gpu::ViewBlock, tileSize), EIKONAL_MEMBER(gpu::ViewBlock, subPixel),
        EIKONAL_MEMBER(gpu::ViewBlock, exposureScale), EIKONAL_MEMBER(gpu::ViewBlock, roundIndex),
        EIKONAL_MEMBER(gpu::ViewBlock, sampleWeight), EIKONAL_MEMBER(gpu::ViewBlock, filmStart),
        {"ambient[0]", offsetof(gpu::ViewBlock, ambient)},
        EIKONAL_MEMBER(gpu::ViewBlock, contentMin), EIKONAL_MEMBER(gpu::ViewBlock, negligibleGradient),
        EIKONAL_MEMBER(gpu::ViewBlock, contentMax), EIKONAL_MEMBER(gpu::ViewBlock, dispersedAtStart),
        EIKONAL_MEMBER(gpu::ViewBlock, bandToRgb), EIKONAL_MEMBER(gpu::ViewBlock, bandChannel),
        EIKONAL_MEMBER(gpu::ViewBlock, mostGenerations), EIKONAL_MEMBER(gpu::ViewBlock, leastReflected),
        EIKONAL_MEMBER(gpu::ViewBlock, lensSequence), EIKONAL_MEMBER(gpu::ViewBlock, lensRadius),
        EIKONAL_MEMBER(gpu::ViewBlock, focusDistance), EIKONAL_MEMBER(gpu::ViewBlock, halfWeight),
        EIKONAL_MEMBER(gpu::ViewBlock, lensHalf), EIKONAL_MEMBER(gpu::ViewBlock, sampleShare),
        EIKONAL_MEMBER(gpu::ViewBlock, fewRays), EIKONAL_MEMBER(gpu::ViewBlock, stepsPerDispatch),
        EIKONAL_MEMBER(gpu::ViewBlock, padA),
    };
}

test::Members domainBlockMembers() {
    return {
        EIKONAL_MEMBER(gpu::DomainBlock, min), EIKONAL_MEMBER(gpu::DomainBlock, voxel),
        EIKONAL_MEMBER(gpu::DomainBlock, max), EIKONAL_MEMBER(gpu::DomainBlock, ior),
        EIKONAL_MEMBER(gpu::DomainBlock, scale), EIKONAL_MEMBER(gpu::DomainBlock, dispersion),
        EIKONAL_MEMBER(gpu::DomainBlock, size), EIKONAL_MEMBER(gpu::DomainBlock, pad)
    };
}

test::Members pixelReflectionsMembers() {
    test::Members members = {
        EIKONAL_MEMBER(gpu::PixelReflections, steepestX), EIKONAL_MEMBER(gpu::PixelReflections, waiting),
        EIKONAL_MEMBER(gpu::PixelReflections, steepestW), EIKONAL_MEMBER(gpu::PixelReflections, facets),
        EIKONAL_MEMBER(gpu::PixelReflections, steepestTransmittance), EIKONAL_MEMBER(gpu::PixelReflections, spread),
        EIKONAL_MEMBER(gpu::PixelReflections, startX), EIKONAL_MEMBER(gpu::PixelReflections, padB),
        EIKONAL_MEMBER(gpu::PixelReflections, startTransmittance), EIKONAL_MEMBER(gpu::PixelReflections, padC),
        EIKONAL_MEMBER(gpu::PixelReflections, startW), EIKONAL_MEMBER(gpu::PixelReflections, padD),
    };
    const test::Members waiting = {
        EIKONAL_MEMBER(gpu::Reflection, x), EIKONAL_MEMBER(gpu::Reflection, throughputS),
        EIKONAL_MEMBER(gpu::Reflection, w), EIKONAL_MEMBER(gpu::Reflection, throughputP),
        EIKONAL_MEMBER(gpu::Reflection, transmittance), EIKONAL_MEMBER(gpu::Reflection, generationAndSpread),
    };
    for (int i = 0; i < gpu::kMostWaiting; ++i) {
        const std::size_t offset = offsetof(gpu::PixelReflections, list) + std::size_t(i) * sizeof(gpu::Reflection);
        members.merge(test::prefixed("list[" + std::to_string(i) + "].", waiting, offset));
    }
    return members;
}

TEST(BlockLayout, OfTheMarchIsTheCompilers) {
    const gpu::Kernel march(test::sharedContext(), "viewer/march.comp.glsl",
                            {"EFFECT_REFRACTION", "EFFECT_ABSORPTION", "SAMPLES_PER_HALF 0"});
    const auto view = test::uniformBlockLayout(march, "View");
    EXPECT_EQ(view.members, test::prefixed("viewGiven.", viewBlockMembers()));
    EXPECT_EQ(view.bytes, sizeof(gpu::ViewBlock));
    const auto domain = test::uniformBlockLayout(march, "Domain");
    EXPECT_EQ(domain.members, test::prefixed("domainGiven.", domainBlockMembers()));
    EXPECT_EQ(domain.bytes, sizeof(gpu::DomainBlock));
}

TEST(BlockLayout, OfTheRayListsIsTheCompilers) {
    const gpu::Kernel march(test::sharedContext(), "viewer/march.comp.glsl", {"SAMPLES_PER_HALF 0"});
    const auto expected = [](const std::string& list) {
        return test::Members{{list + "Head.groups[0]", offsetof(gpu::RayListHead, groups)},
                             {list + "Head.count", offsetof(gpu::RayListHead, count)},
                             {list + "Rays[0]", sizeof(gpu::RayListHead)}};
    };
    EXPECT_EQ(test::storageBlockLayout(march, "TakenRays").members, expected("taken"));
    EXPECT_EQ(test::storageBlockLayout(march, "FilledRays").members, expected("filled"));
}

TEST(BlockLayout, OfInsetsIsTheCompilers) {
    const gpu::Kernel march(test::sharedContext(), "viewer/march.comp.glsl",
                            {"EFFECT_REFRACTION", "INSETS", "SAMPLES_PER_HALF 0"});
    const auto layout = test::uniformBlockLayout(march, "InsetsBlock");
    const test::Members expected{
        EIKONAL_MEMBER(gpu::InsetsBlock, insetValueScale), EIKONAL_MEMBER(gpu::InsetsBlock, insetPadA),
        EIKONAL_MEMBER(gpu::InsetsBlock, insetExtentScale), EIKONAL_MEMBER(gpu::InsetsBlock, insetPadB)};
    EXPECT_EQ(layout.members, expected);
    EXPECT_EQ(layout.bytes, sizeof(gpu::InsetsBlock));
}

TEST(BlockLayout, OfReflectionsIsTheCompilers) {
    const gpu::Kernel reflect(test::sharedContext(), "viewer/reflect.comp.glsl", {"EFFECT_REFRACTION"});
    const auto layout = test::storageBlockLayout(reflect, "Reflections");
    EXPECT_EQ(layout.members, test::prefixed("reflections[0].", pixelReflectionsMembers()));
    EXPECT_EQ(layout.stride, sizeof(gpu::PixelReflections));
}

TEST(BlockLayout, OfALookIsTheCompilers) {
    const gpu::Kernel picture(test::sharedContext(), "viewer/picture.comp.glsl", {"LOOK_SLICE", "LOOK_INDEX"});
    const auto look = test::uniformBlockLayout(picture, "LookBlock");
    const test::Members members{
        EIKONAL_MEMBER(gpu::LookBlock, sliceAxis), EIKONAL_MEMBER(gpu::LookBlock, slicePosition),
        EIKONAL_MEMBER(gpu::LookBlock, lowest), EIKONAL_MEMBER(gpu::LookBlock, highest)};
    EXPECT_EQ(look.members, members);
    EXPECT_EQ(look.bytes, sizeof(gpu::LookBlock));
}

TEST(BlockLayout, OfRowsOfARayIsTheCompilers) {
    std::array<gpu::uint, sizeof(gpu::RayState) / sizeof(gpu::uint)> words;
    std::iota(words.begin(), words.end(), 1u);
    const auto ray = std::bit_cast<gpu::RayState>(words);
    const gpu::RayRows rows = gpu::rowsOf(ray);
    static_assert(sizeof rows == sizeof ray);
    EXPECT_EQ(std::memcmp(&rows, &ray, sizeof ray), 0);
    const gpu::RayState again = gpu::rayOf(rows);
    EXPECT_EQ(std::memcmp(&again, &ray, sizeof ray), 0);
}

} // namespace
} // namespace eikonal
