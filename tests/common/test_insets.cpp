// Objects with lattices of their own: what is composed once, what goes with their place, and what scenes are refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "common/atlas.h"
#include "common/effects.h"
#include "common/inset_bricks.h"
#include "common/insets.h"
#include "common/physics.h"
#include "common/scene_hash.h"
#include "common/stage_fields.h"
#include "tests/common/scene_text.h"

namespace eikonal {
namespace {

using glm::dvec3;

const std::string kBall = "[domain]\nresolution = 24\n[[object]]\nname = \"ball\"\nresolution = 40\nradius = 0.3\n";

Fields imageFields(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return composeImageFields(sceneOf(text, overrides));
}

TEST(Composition, HasTheGradientOfItsValue) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.1, 1.0);
    const auto sample = [&] { return glm::dvec4(uniform(random), uniform(random), uniform(random), uniform(random)); };
    const glm::dvec4 below = sample(), coverage = sample(), own = sample();
    const auto at = [](const glm::dvec4& value, const dvec3& x) {
        return glm::dvec4(dvec3(value), value.w + glm::dot(dvec3(value), x));
    };
    const auto valueAt = [&](const dvec3& x) { return f64::composedOver(at(below, x), at(coverage, x), at(own, x)).w; };
    const double h = 1e-5;
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 step(0.0);
        step[axis] = h;
        const double slope = (valueAt(step) - valueAt(-step)) / (2.0 * h);
        EXPECT_NEAR(f64::composedOver(below, coverage, own)[axis], slope, 1e-9);  // exact for products, to rounding over h
    }
    EXPECT_EQ(f64::composedOver(below, glm::dvec4(0.0), glm::dvec4(0.0)), below) << "nothing over it";
    EXPECT_EQ(f64::composedOver(below, glm::dvec4(0.0, 0.0, 0.0, 1.0), own), own) << "all of it covered";
}

TEST(Insets, HaveAsManyVoxelsAsTheyAskForAlongTheirLongestSide) {
    const Fields fields = imageFields("[[object]]\nshape = \"box\"\nsize = [0.4, 0.2, 0.6]\nscale = 0.5\nresolution = 40\n",
                                      {"domain.resolution=8"});
    ASSERT_EQ(fields.insets.size(), 1u);
    const Lattice& lattice = fields.insets[0].grids->lattice;
    EXPECT_EQ(lattice.size.z, 40);
    EXPECT_EQ(lattice.size.x, 2 * 7 + 18) << "7 voxels of tails on each side of 0.4 at 0.6 in 26 voxels";
    EXPECT_DOUBLE_EQ(lattice.voxel, 0.6 / 26.0);
    EXPECT_DOUBLE_EQ(voxelOf(fields.insets[0]), 0.5 * 0.6 / 26.0);
}

TEST(Insets, FadeOutWithinTheirLattices) {
    const Fields fields = imageFields(kBall);
    const InsetGrids& grids = *fields.insets[0].grids;
    const auto& coverage = grids.quantities[gpu::kInsetCoverage].varying;
    const glm::ivec3 size = grids.lattice.size;
    for (int j = 0; j < size.y; ++j)
        for (int i = 0; i < size.x; ++i) {
            const float edge = coverage[std::size_t(j) * std::size_t(size.x) + std::size_t(i)].w;
            EXPECT_LE(edge, 1e-5f);  // erfc(6.5 / (1.5 sqrt 2)) / 2 is 7e-6
        }
}

TEST(Insets, AreComposedAloneWhereverTheyLie) {
    const Fields here = imageFields(kBall), there = imageFields(kBall, {"object.0.translate=[0.3, 0.1, 0]",
                                                                        "object.0.rotate=[0, 50, 0]", "object.0.scale=1.5"});
    const InsetGrids &a = *here.insets[0].grids, &b = *there.insets[0].grids;
    EXPECT_EQ(a.lattice, b.lattice);
    EXPECT_EQ(a.quantities[gpu::kInsetCoverage].varying, b.quantities[gpu::kInsetCoverage].varying);
    EXPECT_EQ(a.depth.values, b.depth.values);
    EXPECT_TRUE(a.quantities[gpu::kInsetIndex].varying.empty()) << "the same index everywhere needs no grid";
    EXPECT_TRUE(here.iorGradient.empty()) << "nor is it on the domain's lattice";
}

TEST(Insets, DoNotChangeTheBake) {
    const Scene with = sceneOf(kBall), without = sceneOf("[domain]\nresolution = 24\n[[object]]\nradius = 0.3\n");
    EXPECT_EQ(sceneHash(with, composeFields(with)), sceneHash(without, composeFields(without)));
    EXPECT_EQ(composeFields(with).ior.values, composeFields(without).ior.values);
    EXPECT_TRUE(composeFields(with).insets.empty());
    EXPECT_TRUE(differingKeys(with, without).empty());
}

TEST(Insets, CallForTheirEffects) {
    const auto effectsWith = [](const std::vector<std::string>& overrides) {
        const Scene scene = sceneOf(kBall, overrides);
        return decideEffects(scene, composeImageFields(scene));
    };
    const EffectSet glass = effectsWith({});
    EXPECT_TRUE(glass.has(Effect::kRefraction) && glass.has(Effect::kReflection));
    EXPECT_FALSE(glass.has(Effect::kAbsorption) || glass.has(Effect::kOpaque) || glass.has(Effect::kDispersion) ||
                 glass.has(Effect::kTint) || glass.has(Effect::kRoughness));
    EXPECT_TRUE(effectsWith({"object.0.absorption=1"}).has(Effect::kAbsorption));
    EXPECT_TRUE(effectsWith({"object.0.scattering=1"}).has(Effect::kScattering));
    EXPECT_TRUE(effectsWith({"object.0.emission=\"x > 0 ? 1 : 0\""}).has(Effect::kEmission));
    EXPECT_TRUE(effectsWith({"object.0.cauchy_b=0.01"}).has(Effect::kDispersion));
    EXPECT_TRUE(effectsWith({"object.0.reflection_tint=[1, 0.5, 1]"}).has(Effect::kTint));
    EXPECT_TRUE(effectsWith({"object.0.surface=rough"}).has(Effect::kRoughness));
    const EffectSet opaque = effectsWith({"object.0.opaque=true"});
    EXPECT_TRUE(opaque.has(Effect::kOpaque));
    EXPECT_FALSE(opaque.has(Effect::kRefraction) || opaque.has(Effect::kReflection));
    const EffectSet air = effectsWith({"object.0.ior=1.0", "object.0.absorption=1"});
    EXPECT_FALSE(air.has(Effect::kRefraction) || air.has(Effect::kReflection)) << "a boundary without contrast";
}

TEST(Insets, RefuseObjectsOverThemWithoutALatticeOfTheirOwn) {
    const std::string later = kBall + "[[object]]\nname = \"floor\"\nshape = \"plane\"\n";
    EXPECT_EQ(messageOf([&] { imageFields(later, {"object.1.translate=[0, -0.2, 0]"}); }),
              "s.toml:7:1: object 'floor': expected objects without a resolution before those with one that they may overlap, "
              "found it after object 'ball'; list it earlier, or give it a resolution too");
    EXPECT_NO_THROW(imageFields(later, {"object.1.translate=[0, -0.2, 0]", "object.1.resolution=64"}));
    EXPECT_NO_THROW(imageFields(later, {"object.1.translate=[0, -0.9, 0]", "domain.resolution=80"})) << "they are apart";
    const std::string aside = kBall + "[[object]]\nshape = \"box\"\nsize = [0.2, 0.2, 0.2]\n";
    EXPECT_NO_THROW(imageFields(aside, {"object.1.translate=[0.8, 0.8, 0.8]", "domain.resolution=80"}));
}

TEST(Insets, RefuseResolutionsThatSmoothingTakesAllOf) {
    EXPECT_EQ(messageOf([] { imageFields(kBall, {"object.0.resolution=14"}); }),
              "--set object.0.resolution=14: object.resolution: expected at least 15 voxels, of which smoothing takes 7 on each side, "
              "found 14");
}

TEST(Insets, RefuseMoreOfThemThanBits) {
    std::string text = "[domain]\nresolution = 8\n";
    for (int i = 0; i <= gpu::kMostInsets; ++i) text += "[[object]]\nresolution = 20\nsmooth = 0.5\n";
    EXPECT_EQ(messageOf([&] { imageFields(text); }), "s.toml: expected at most 32 objects with a resolution, found 33");
}

TEST(InsetBricks, HaveTheBitOfWhateverIsThere) {
    const std::string ring = "[[object]]\nshape = \"torus\"\nresolution = 48\nrotate = [60, 10, 0]\nscale = 0.9\n";
    const Fields fields = imageFields(kBall + ring,
                                      {"object.0.translate=[0.5, 0.4, -0.3]", "domain.resolution=64"});
    const DenseGrid<InsetBrick> bricks = insetBricksOf(fields);
    std::size_t empty = 0;
    for (const InsetBrick& brick : bricks.values) empty += brick.about == 0 ? 1 : 0;
    EXPECT_GT(empty, bricks.values.size() / 3) << "about their boxes' corners there is nothing";
    for (std::size_t n = 0; n < fields.insets.size(); ++n) {
        const InsetGrids& grids = *fields.insets[n].grids;
        const auto& coverage = grids.quantities[gpu::kInsetCoverage].varying;
        for (std::size_t v = 0; v < coverage.size(); ++v) {
            if (coverage[v].w == 0.0f) continue;
            const int nx = grids.lattice.size.x, ny = grids.lattice.size.y;
            const glm::ivec3 voxel(int(v) % nx, int(v) / nx % ny, int(v) / (nx * ny));
            const dvec3 world(fields.insets[n].worldFromLocal * glm::dvec4(grids.lattice.worldFromIndex(voxel), 1.0));
            const glm::ivec3 at(glm::floor((world - fields.lattice.min) / (kBrickVoxels * fields.lattice.voxel)));
            if (glm::any(glm::lessThan(at, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(at, bricks.size))) continue;
            ASSERT_TRUE((bricks.at(at).about >> n) & 1u);
            ASSERT_LE(bricks.at(at).finestVoxel, 1.001 * voxelOf(fields.insets[n]) / fields.lattice.voxel);
        }
    }
}

TEST(InsetBricks, AddWhatInsetsHoldToTheDomainsOwn) {
    const Fields fields = imageFields(kBall, {"object.0.absorption=1", "object.0.resolution=64", "object.0.radius=0.6",
                                              "domain.resolution=48"});
    FieldPyramid pyramid = fieldPyramidOf(fields);
    addInsets(fields, pyramid);
    const FieldBrick& corner = pyramid.bricks.at(0, 0, 0);
    EXPECT_FALSE(corner.matter || corner.boundary);
    EXPECT_EQ(corner.gradientMax, 0.0f);
    const FieldBrick& middle = pyramid.bricks.at(6, 6, 6);
    EXPECT_TRUE(middle.matter && middle.evenMatter);
    EXPECT_FALSE(middle.boundary);
    EXPECT_EQ(middle.gradientMax, 0.0f) << "rays fly through the inside";
    EXPECT_EQ(middle.iorMax, 1.5f);
    const FieldBrick& rim = pyramid.bricks.at(6, 6, int((1.0 + 0.6) / 2.0 * 48) / kBrickVoxels);
    EXPECT_TRUE(rim.boundary && !rim.evenMatter);
    EXPECT_GT(rim.gradientMax, 0.1f);
}

TEST(Insets, SayWhereTheyAreCut) {
    const Fields inside = imageFields(kBall);
    EXPECT_FALSE(reachesBeyond(inside.insets[0], inside.lattice));
    const Fields across = imageFields(kBall, {"object.0.translate=[0.9, 0, 0]"});
    EXPECT_TRUE(reachesBeyond(across.insets[0], across.lattice));
}

TEST(Atlas, HoldsBoxesApart) {
    const std::vector<glm::ivec3> sizes{{5, 7, 3}, {130, 20, 40}, {34, 34, 34}, {34, 34, 34}, {1, 1, 1}, {130, 130, 130}};
    for (const int most : {2048, 256}) {
        const Atlas atlas = packed(sizes, most);
        for (std::size_t a = 0; a < sizes.size(); ++a) {
            EXPECT_TRUE(glm::all(glm::greaterThanEqual(atlas.first[a], glm::ivec3(0))));
            EXPECT_TRUE(glm::all(glm::lessThanEqual(atlas.first[a] + sizes[a], atlas.size)));
            for (std::size_t b = 0; b < a; ++b) {
                const bool apart = glm::any(glm::lessThanEqual(atlas.first[a] + sizes[a], atlas.first[b])) ||
                                   glm::any(glm::lessThanEqual(atlas.first[b] + sizes[b], atlas.first[a]));
                EXPECT_TRUE(apart) << a << " and " << b;
            }
        }
    }
    EXPECT_EQ(packed({}, 64).size, glm::ivec3(1));
    EXPECT_LE(packed(std::vector<glm::ivec3>(40, glm::ivec3(64)), 512).size.z, 512) << "side by side where too high";
}

} // namespace
} // namespace eikonal
