#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/depth.h"
#include "common/fields.h"
#include "tests/common/scene_text.h"

namespace eikonal {
namespace {

Fields fieldsOf(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return composeFields(sceneOf(text, overrides));
}

double erfcProfile(double distance, double b) { return 0.5 * std::erfc(distance / (std::numbers::sqrt2 * b)); }

template <class Function>
void forEachVoxel(const Lattice& lattice, const Function& function) {
    for (int k = 0; k < lattice.size.z; ++k)
        for (int j = 0; j < lattice.size.y; ++j)
            for (int i = 0; i < lattice.size.x; ++i)
                function(glm::ivec3(i, j, k), lattice.worldFromIndex({i, j, k}));
}

TEST(Lattice, VoxelsAreCubesCountsRoundUp) {
    Domain domain;
    domain.min = glm::dvec3(-1.0, 0.0, 0.0);
    domain.max = glm::dvec3(1.0, 1.01, 0.3);
    domain.resolution = 20;
    const Lattice lattice = latticeOf(domain);
    EXPECT_DOUBLE_EQ(lattice.voxel, 0.1);
    EXPECT_EQ(lattice.size, glm::ivec3(20, 11, 3));  // 0.3 is 3 voxels, not 4, whatever its binary digits
    EXPECT_DOUBLE_EQ(lattice.worldFromIndex({0, 0, 0}).x, -0.95);
    domain.max = glm::dvec3(1.0, 2.0, 2.0);
    domain.resolution = 4096;
    EXPECT_NE(messageOf([&] { latticeOf(domain); }).find("2^31"), std::string::npos);
}

TEST(Fields, SphereHasTheErfcProfileInItsRadius) {
    const Fields fields = fieldsOf("[domain]\nresolution = 40\nsmooth = 2\n[[object]]\nradius = 0.6\nior = 1.5\n");
    const double b = 2.0 * fields.lattice.voxel;
    double worst = 0.0;
    forEachVoxel(fields.lattice, [&](const glm::ivec3& v, const glm::dvec3& p) {
        const double n = 1.0 + 0.5 * erfcProfile(glm::length(p) - 0.6, b);
        worst = std::max(worst, std::abs(double(fields.ior.at(v)) - n));
    });
    EXPECT_LT(worst, 8e-7);  // rounding to float, and coverage below 1e-6 counts as none
}

TEST(Fields, AbsorptionIsByAreaAndKeepsTheVolume) {
    const Fields fields = fieldsOf("[domain]\nresolution = 48\n[[object]]\nradius = 0.6\nabsorption = [1, 2, 0]\n");
    glm::dvec3 sum(0.0);
    for (const glm::vec3& sigma : fields.sigmaA.values)
        sum += glm::dvec3(sigma) * std::pow(fields.lattice.voxel, 3.0);
    const double volume = 4.0 / 3.0 * std::numbers::pi * 0.216;
    // The linear ramp in d is the share of a voxel that a plane cuts off, up to its tilt: a few 1e-3 at 14 voxels' radius.
    EXPECT_NEAR(sum.x / volume, 1.0, 5e-3);
    EXPECT_NEAR(sum.y, 2.0 * sum.x, 1e-4);
    EXPECT_EQ(sum.z, 0.0);
    EXPECT_TRUE(fields.sigmaS.empty());
    EXPECT_TRUE(fields.emission.empty());
    EXPECT_TRUE(fields.opaque.empty());
}

TEST(Fields, LaterObjectsWinWhereTheyOverlap) {
    const char* water = "[[object]]\nshape = \"box\"\nsize = [1.6, 1.6, 1.6]\nior = 1.33\nabsorption = 0.2\n";
    const char* ball = "[[object]]\nradius = 0.4\nior = 1.5\nabsorption = 3\n";
    const std::string domain = "[domain]\nresolution = 32\nsmooth = 1\n";
    const Fields ballLast = fieldsOf(domain + water + ball), waterLast = fieldsOf(domain + ball + water);
    const glm::ivec3 centre(16);
    EXPECT_NEAR(ballLast.ior.at(centre), 1.5, 1e-5);
    EXPECT_NEAR(ballLast.sigmaA.at(centre).x, 3.0, 1e-5);
    EXPECT_NEAR(waterLast.ior.at(centre), 1.33, 1e-5);
    EXPECT_NEAR(waterLast.sigmaA.at(centre).x, 0.2, 1e-5);
    const Lattice& lattice = ballLast.lattice;
    forEachVoxel(lattice, [&](const glm::ivec3& v, const glm::dvec3& p) {
        const glm::dvec3 q = glm::abs(p) - 0.8;
        const double box = glm::length(glm::max(q, glm::dvec3(0.0))) + std::min(std::max({q.x, q.y, q.z}), 0.0);
        const double inWater = 1.0 + erfcProfile(box, lattice.voxel) * 0.33;
        const double n = inWater + erfcProfile(glm::length(p) - 0.4, lattice.voxel) * (1.5 - inWater);
        ASSERT_NEAR(ballLast.ior.at(v), n, 3e-7);
    });
}

TEST(Fields, ScalingTheWorldLeavesTheIndexAndDividesTheGradient) {
    const std::string object = "[[object]]\nshape = \"torus\"\nradius = 0.5\ntube = 0.2\nrotate = [30, 20, 10]\n";
    const Fields one = fieldsOf("[domain]\nresolution = 24\n" + object + "translate = [0.1, 0.2, 0]\n");
    const Fields two = fieldsOf("[domain]\nmin = [-2, -2, -2]\nmax = [2, 2, 2]\nresolution = 24\n" + object +
                                "translate = [0.2, 0.4, 0]\nscale = 2\n");
    for (std::size_t v = 0; v < one.ior.values.size(); ++v) {
        ASSERT_NEAR(one.ior.values[v], two.ior.values[v], 2e-7);
        ASSERT_LT(glm::length(one.iorGradient.values[v] - 2.0f * two.iorGradient.values[v]), 1e-5f);
    }
    EXPECT_EQ(one.interface.values, two.interface.values);
}

TEST(Fields, ShiftingTheWorldChangesNothing) {
    const std::string object = "[[object]]\nradius = 0.5\nscattering = \"1 + x\"\n";
    const Fields here = fieldsOf("[domain]\nresolution = 16\n" + object);
    const Fields there = fieldsOf("[domain]\nmin = [9, -11, 4]\nmax = [11, -9, 6]\nresolution = 16\n" + object +
                                  "translate = [10, -10, 5]\n");
    for (std::size_t v = 0; v < here.ior.values.size(); ++v) {
        ASSERT_NEAR(here.ior.values[v], there.ior.values[v], 2e-7);
        ASSERT_NEAR(here.sigmaS.values[v].x, there.sigmaS.values[v].x, 1e-6);
    }
}

TEST(Fields, ConstantsStayPerSceneUnitWhateverTheScale) {
    const Fields fields = fieldsOf("[domain]\nresolution = 16\n[[object]]\nradius = 0.25\nscale = 3\nabsorption = 1.5\n");
    EXPECT_FLOAT_EQ(fields.sigmaA.at(8, 8, 8).x, 1.5f);
}

TEST(Fields, FieldHasNoBoundaryAndSamplesItsFormulaAtPoints) {
    const Fields fields = fieldsOf("[domain]\nresolution = 20\n[[object]]\nshape = \"field\"\nsize = [2, 2, 2]\n"
                                   "ior = \"r < 1 ? sqrt(2 - r*r) : 1\"\n");
    forEachVoxel(fields.lattice, [&](const glm::ivec3& v, const glm::dvec3& p) {
        const double r = glm::length(p);
        ASSERT_NEAR(fields.ior.at(v), r < 1.0 ? std::sqrt(2.0 - r * r) : 1.0, 2e-7);
    });
    EXPECT_TRUE(fields.interface.empty());
}

TEST(Fields, FieldWithoutIndexLeavesItAndFillsItsBoxWithSmoke) {
    const Fields fields = fieldsOf("[domain]\nresolution = 20\nior = 1.33\n[[object]]\nshape = \"field\"\n"
                                   "size = [1, 1, 1]\nscattering = 2\nanisotropy = 0.5\n");
    EXPECT_TRUE(fields.iorGradient.empty());
    EXPECT_FLOAT_EQ(fields.iorUniform, 1.33f);
    forEachVoxel(fields.lattice, [&](const glm::ivec3& v, const glm::dvec3& p) {
        const bool inside = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) < 0.5;
        ASSERT_EQ(fields.sigmaS.at(v).x, inside ? 2.0f : 0.0f);
    });
}

TEST(Fields, BackgroundIsAnExpressionOfTheWorld) {
    const Fields fields = fieldsOf("[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\nresolution = 10\nior = \"1 + 0.1*y\"\n");
    EXPECT_NEAR(fields.ior.at(3, 7, 2), 1.075, 1e-6);
    // Linear n: every order of difference is exact, at the faces too; what is left is rounding of n over the voxel.
    for (const glm::vec3& gradient : fields.iorGradient.values)
        ASSERT_LT(glm::length(gradient - glm::vec3(0.0f, 0.1f, 0.0f)), 1e-5f);
}

TEST(Fields, UniformIndexIsOneNumber) {
    const Fields vacuum = fieldsOf("[domain]\nresolution = 8\n[medium]\nscattering = 0.5\nanisotropy = 0.3\n");
    EXPECT_TRUE(vacuum.ior.empty());
    EXPECT_TRUE(vacuum.iorGradient.empty());
    EXPECT_EQ(vacuum.iorUniform, 1.0f);
    EXPECT_FLOAT_EQ(vacuum.anisotropy.at(4, 4, 4), 0.3f);
    const Fields matched = fieldsOf("[domain]\nresolution = 8\nior = 1.4\n[[object]]\nior = 1.4\nabsorption = 1\n");
    EXPECT_TRUE(matched.iorGradient.empty());
    EXPECT_FLOAT_EQ(matched.iorUniform, 1.4f);
    EXPECT_FALSE(matched.sigmaA.empty());
}

TEST(Fields, BoundaryIsMarkedWhereTheIndexIsBetweenTheTwoSides) {
    const Fields fields = fieldsOf("[domain]\nresolution = 40\nsmooth = 1.5\n[[object]]\nradius = 0.6\nior = 1.5\n");
    const double b = 1.5 * fields.lattice.voxel;
    forEachVoxel(fields.lattice, [&](const glm::ivec3& v, const glm::dvec3& p) {
        const double distance = std::abs(glm::length(p) - 0.6);
        if (std::abs(distance - 2.75 * b) > 1e-6) {
            ASSERT_EQ(fields.interface.at(v) != 0, distance < 2.75 * b) << glm::length(p);
        }
        if (fields.interface.at(v) == 0) {
            const double n = double(fields.ior.at(v));  // outside the band: one side's index to 0.3 % of the contrast
            ASSERT_LT(std::min(std::abs(n - 1.0), std::abs(n - 1.5)), 0.0031 * 0.5);
        }
    });
}

TEST(Fields, MatchedAndBuriedBoundariesAreNone) {
    const Fields matched = fieldsOf("[domain]\nresolution = 16\n[[object]]\nior = 1.00005\n");
    EXPECT_TRUE(matched.interface.empty());
    const Fields buried = fieldsOf("[domain]\nresolution = 32\nsmooth = 1\n[[object]]\nradius = 0.3\nior = 1.5\n"
                                   "[[object]]\nradius = 0.8\nior = 1.3\n");
    EXPECT_EQ(buried.interface.at(16 + 5, 16, 16), 0);   // r = 0.34: the small sphere's, covered by the large one
    EXPECT_EQ(buried.interface.at(16 + 12, 16, 16), 255);  // r = 0.78
}

TEST(Fields, SharpBoundaryIsAreaCoverage) {
    const Fields fields = fieldsOf("[domain]\nresolution = 20\n[[object]]\nshape = \"box\"\nsize = [1.03, 4, 4]\n"
                                   "smooth = false\nior = 1.5\n");
    // The face at 0.515 cuts the voxel from 0.5 to 0.6: 15 % of it are glass.
    EXPECT_NEAR(fields.ior.at(15, 10, 10), 1.0 + 0.15 * 0.5, 1e-6);
    EXPECT_NEAR(fields.ior.at(14, 10, 10), 1.5, 1e-6);
    EXPECT_NEAR(fields.ior.at(16, 10, 10), 1.0, 1e-6);
    EXPECT_EQ(fields.interface.at(16, 10, 10), 255);
    EXPECT_EQ(fields.interface.at(18, 10, 10), 0);
}

TEST(Fields, OpaqueMatterLeavesTheIndexAndGlassTakesItAway) {
    const Fields fields = fieldsOf("[domain]\nresolution = 20\nior = 1.33\n[[object]]\nshape = \"plane\"\nsize = [4, 4]\n"
                                   "opaque = true\nchecker = [[1, 0, 0], [0, 0, 1], 0.5]\n[[object]]\nradius = 0.5\n"
                                   "ior = 1.5\n");
    const auto freeShare = [&](int i, int j, int k) { return freeShareAt(fields.opaque, fields.opaque.offset(i, j, k)); };
    EXPECT_EQ(freeShare(1, 5, 1), 0.0);
    EXPECT_EQ(freeShare(1, 15, 1), 1.0);
    EXPECT_EQ(freeShare(10, 9, 10), 1.0);                     // in the ball
    EXPECT_NEAR(fields.ior.at(1, 5, 1), 1.33, 1e-6);
    EXPECT_EQ(fields.albedo.at(1, 5, 1), glm::vec3(1.0f, 0.0f, 0.0f));  // cells (-2, -2): even
    EXPECT_EQ(fields.albedo.at(1, 5, 6), glm::vec3(0.0f, 0.0f, 1.0f));  // cells (-2, -1): odd
    EXPECT_EQ(fields.albedo.at(1, 10, 1), glm::vec3(1.0f, 0.0f, 0.0f));  // continued above the surface
}

TEST(Fields, AnisotropyIsWeightedWithItsScattering) {
    const Fields fields = fieldsOf("[domain]\nresolution = 20\n[medium]\nscattering = 1\nanisotropy = 0.8\n[[object]]\n"
                                   "shape = \"box\"\nsize = [1.1, 4, 4]\nscattering = 3\nanisotropy = 0\n");
    // Half of voxel 15 is the box's: mean cosine (0.5 * 1 * 0.8 + 0.5 * 3 * 0) / 2.
    EXPECT_NEAR(fields.sigmaS.at(15, 10, 10).x, 2.0, 1e-5);
    EXPECT_NEAR(fields.anisotropy.at(15, 10, 10), 0.2, 1e-5);
}

TEST(Fields, AnisotropyByBandIsWeightedWithTheScatteringOfItsBand) {
    const std::string medium = "[domain]\nresolution = 20\n[medium]\nscattering = [1, 2, 4]\nanisotropy = [0.8, 0.4, -0.9]\n";
    const std::string box = "[[object]]\nshape = \"box\"\nsize = [1.1, 4, 4]\nscattering = 3\nanisotropy = 0.1\n";
    const Fields fields = fieldsOf(medium + box);
    // Half of voxel 15 is the box's.
    const glm::vec3 mixed = fields.anisotropyByBand.at(15, 10, 10);
    EXPECT_NEAR(mixed.r, (1.0 * 0.8 + 3.0 * 0.1) / 4.0, 1e-6);
    EXPECT_NEAR(mixed.g, (2.0 * 0.4 + 3.0 * 0.1) / 5.0, 1e-6);
    EXPECT_NEAR(mixed.b, (4.0 * -0.9 + 3.0 * 0.1) / 7.0, 1e-6);
    EXPECT_EQ(fields.anisotropy.at(15, 10, 10), mixed.b) << "farthest from 0";
    EXPECT_EQ(fields.anisotropyByBand.at(10, 10, 10), glm::vec3(0.1f));
    EXPECT_TRUE(fieldsOf("[medium]\nscattering = 1\nanisotropy = [0.8, 0.8, 0.8]\n").anisotropyByBand.empty());
    const Fields covered = fieldsOf(medium + "[[object]]\nshape = \"box\"\nsize = [4, 4, 4]\nscattering = 3\nanisotropy = 0.1\n");
    EXPECT_TRUE(covered.anisotropyByBand.empty()) << "what differed is covered";
    EXPECT_EQ(covered.anisotropy.at(15, 10, 10), 0.1f);
}

TEST(Fields, AnisotropyOfAMediumMayBeAnExpression) {
    const Fields fields = fieldsOf("[domain]\nresolution = 4\n[medium]\nscattering = 1\nanisotropy = \"0.5*x\"\n");
    EXPECT_FLOAT_EQ(fields.anisotropy.at(3, 1, 2), 0.375f);
    EXPECT_TRUE(fields.anisotropyByBand.empty());
}

TEST(Fields, ImpossibleValuesNameObjectAndPlace) {
    const auto message = [](const std::string& text) { return messageOf([&] { fieldsOf("[domain]\nresolution = 4\n" + text); }); };
    const std::string negative = message("[[object]]\nname = \"lens\"\nshape = \"field\"\nior = \"x\"\n");
    EXPECT_NE(negative.find("s.toml:6:7: object 'lens': ior is -0.75 at (-0.75, -0.75, -0.75), expected a finite value > 1e-05 and < 1000"),
              std::string::npos) << negative;
    EXPECT_NE(message("[[object]]\nshape = \"field\"\nior = \"sqrt(-1-r)\"\n").find("ior is"), std::string::npos);
    EXPECT_NE(message("[medium]\nabsorption = \"1/(x-0.25)\"\n").find("domain: absorption is"), std::string::npos);
    EXPECT_NE(message("[[object]]\nemission = \"-r\"\n").find("emission is"), std::string::npos);
    EXPECT_NE(message("[[object]]\nscattering = 1\nanisotropy = \"1+r\"\n").find("anisotropy is"), std::string::npos);
}

TEST(Gradient, IsOfFourthOrderInsideAndSecondAtFaces) {
    double inside[2], faces[2];
    for (int fine = 0; fine < 2; ++fine) {
        const int count = fine ? 64 : 32;
        const double h = 1.0 / count;
        DenseGrid<float> n(glm::ivec3(count, 5, 5), 0.0f);
        for (int i = 0; i < count; ++i)
            for (int jk = 0; jk < 25; ++jk)
                n.at(i, jk % 5, jk / 5) = float(std::exp(3.0 * (i + 0.5) * h));
        const DenseGrid<glm::vec3> gradient = gradientOf(n, h);
        const auto ratio = [&](int i) { return double(gradient.at(i, 2, 2).x) / (3.0 * std::exp(3.0 * (i + 0.5) * h)); };
        const auto error = [&](int i) { return std::abs(ratio(i) - 1.0); };
        // less than the derivative by what linear interpolation adds on the average: h²/12 of its second derivative
        inside[fine] = std::abs(ratio(count / 2) - (1.0 - 9.0 * h * h / 12.0));
        faces[fine] = std::max({error(0), error(1), error(count - 1), error(count - 2)});
    }
    EXPECT_LT(inside[0], 3e-5);             // (3h)^4 / 30 is 2.6e-6; floats over 2h add up to 1e-5
    EXPECT_NEAR(faces[0] / faces[1], 4.0, 0.5);  // second order: halving h quarters the error
    EXPECT_LT(faces[1], 1e-3);              // (3h)² / 3 is 7e-4
}

TEST(Gradient, OfTheSmallestGridsExists) {
    EXPECT_EQ(gradientOf(DenseGrid<float>(glm::ivec3(1), 2.0f), 0.1).at(0, 0, 0), glm::vec3(0.0f));
    DenseGrid<float> two(glm::ivec3(2, 1, 1), 1.0f);
    two.at(1, 0, 0) = 1.5f;
    EXPECT_FLOAT_EQ(gradientOf(two, 0.5).at(0, 0, 0).x, 1.0f);
    EXPECT_FLOAT_EQ(gradientOf(two, 0.5).at(1, 0, 0).x, 1.0f);
}

} // namespace
} // namespace eikonal
