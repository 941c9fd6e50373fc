// Cauchy's B on the grid: composed like the index, and what light of a band finds.
#include <gtest/gtest.h>

#include <cmath>

#include "common/physics.h"
#include "common/spectral_fields.h"
#include "tests/common/scene_text.h"

namespace eikonal {
namespace {

Fields fieldsOf(const std::string& text) { return composeFields(sceneOf("[domain]\nresolution = 24\n" + text)); }

EffectDecision dispersionOf(const std::string& text) {
    const Scene scene = sceneOf("[domain]\nresolution = 12\n" + text);
    return decideEffects(scene, composeFields(scene)).decisions[std::size_t(Effect::kDispersion)];
}

TEST(Dispersion, IsComposedByTheCoverageOfTheIndex) {
    const Fields fields = fieldsOf("[[object]]\nradius = 0.6\nior = 1.5\ncauchy_b = 0.02\n");
    ASSERT_FALSE(fields.cauchyB.empty());
    for (std::size_t v = 0; v < fields.cauchyB.values.size(); ++v) {
        const double coverage = (double(fields.ior.values[v]) - 1.0) / 0.5;
        EXPECT_NEAR(fields.cauchyB.values[v], 0.02 * coverage, 1e-8);  // roundings of n to float: 1e-7 of coverage
    }
}

TEST(Dispersion, LaterObjectsWin) {
    const Fields fields = fieldsOf("[[object]]\nshape = \"box\"\nsize = [4, 4, 4]\nior = 1.5\ncauchy_b = 0.02\n"
                                   "[[object]]\nradius = 0.8\nior = 1.7\ncauchy_b = 0.05\n"
                                   "[[object]]\nradius = 0.2\nior = 1.3\n");
    const auto at = [&](int i) { return fields.cauchyB.at(i, 12, 12); };
    EXPECT_FLOAT_EQ(fields.cauchyB.at(0, 0, 0), 0.02f);
    EXPECT_NEAR(at(6), 0.05, 0.03 * 0.05);  // 3 and 4 voxels from boundaries smoothed by 1.5: 2 % and 0.3 % of each
    EXPECT_LT(at(12), 0.2f * 0.05f);        // 1.5 voxels inside the last: 16 % of what was there before
}

TEST(Dispersion, OfAnIndexOverABoxLeavesItsVacuumAlone) {
    const Fields fields =
        fieldsOf("[[object]]\nshape = \"field\"\nior = \"r < 0.8 ? 1.6 - 0.5*r : 1\"\ncauchy_b = 0.02\n");
    const float strongest = *std::max_element(fields.ior.values.begin(), fields.ior.values.end()) - 1.0f;
    for (std::size_t v = 0; v < fields.cauchyB.values.size(); ++v)
        EXPECT_NEAR(fields.cauchyB.values[v], 0.02f * (fields.ior.values[v] - 1.0f) / strongest, 1e-8f);
}

TEST(Dispersion, FollowsCauchysEquationInEveryBand) {
    const Fields fields = fieldsOf("[[object]]\nradius = 0.6\nior = 1.62\ncauchy_b = 0.013\nabsorption = [1, 2, 3]\n");
    for (const SpectralBand& band : spectralBands(6)) {
        const Fields ofBand = fieldsOfBand(fields, band);
        const double lambda = band.wavelengthMicrons;
        const double a = 1.62 - 0.013 / (0.5876 * 0.5876);  // n = A + B/lambda^2
        // seven voxels inside a boundary of 1.5 coverage is 1 to 2e-5
        EXPECT_NEAR(ofBand.ior.at(12, 12, 12), a + 0.013 / (lambda * lambda), 2e-5);
        EXPECT_EQ(ofBand.sigmaA.at(12, 12, 12), glm::vec3(float(1 + band.channel)));
        EXPECT_TRUE(ofBand.cauchyB.empty());
        // the gradient is that of the band's index: differences are linear
        const auto gradient = gradientOf(ofBand.ior, ofBand.lattice.voxel);
        for (std::size_t v = 0; v < gradient.values.size(); ++v)
            EXPECT_LT(glm::length(gradient.values[v] - ofBand.iorGradient.values[v]), 2e-5f);  // n to float, over h = 1/12
    }
}

TEST(Dispersion, OfOneGlassInAirIsInProportionToItsRefractivity) {
    const auto ratioOf = [](const std::string& text) { return cauchyOverRefractivity(fieldsOf(text)); };
    const std::string ball = "[[object]]\nradius = 0.5\nior = 1.5\ncauchy_b = 0.02\n";
    ASSERT_TRUE(ratioOf(ball));
    EXPECT_NEAR(*ratioOf(ball), 0.04, 1e-6);
    EXPECT_TRUE(ratioOf(ball + "[[object]]\nradius = 0.2\nior = 1.75\ncauchy_b = 0.03\n")) << "a second of the same ratio";
    EXPECT_FALSE(ratioOf(ball + "[[object]]\nradius = 0.2\nior = 1.7\ncauchy_b = 0.03\n"));
    EXPECT_FALSE(ratioOf(ball + "[[object]]\nradius = 0.2\nior = 1.33\n")) << "one does not disperse";
    EXPECT_FALSE(ratioOf("[[object]]\nior = 1.5\n"));
}

TEST(Dispersion, CostsNoGridWhereNothingDisperses) {
    const Fields without = fieldsOf("[[object]]\nior = 1.5\n");
    const Fields zero = fieldsOf("[[object]]\nior = 1.5\ncauchy_b = 0\n");
    EXPECT_TRUE(zero.cauchyB.empty());
    EXPECT_TRUE(zero.cauchyGradient.empty());
    EXPECT_EQ(zero.ior.values, without.ior.values);
}

TEST(Dispersion, IsRefusedWhereNoIndexIsLeft) {
    const std::string message = messageOf([] { fieldsOf("[[object]]\nior = 1.2\ncauchy_b = 1.5\n"); });
    EXPECT_NE(message.find("cauchy_b: expected an index above 0 at 700 nm"), std::string::npos) << message;
}

TEST(Dispersion, IsOnWhereSomethingRefractsByWavelength) {
    EXPECT_TRUE(dispersionOf("[[object]]\ncauchy_b = 0.01\n").on);
    EXPECT_EQ(dispersionOf("[[object]]\n").why, "no object has cauchy_b");
    EXPECT_FALSE(dispersionOf("[[object]]\n").on);
    const EffectDecision leftOut =
        dispersionOf("[[object]]\ncauchy_b = 0.01\n[render]\neffects = [\"refraction\"]\n");
    EXPECT_FALSE(leftOut.on);
    EXPECT_NE(leftOut.why.find("left out by render.effects"), std::string::npos);
    const EffectDecision unrefracted =
        dispersionOf("[[object]]\ncauchy_b = 0.01\n[render]\neffects = [\"dispersion\"]\n");
    EXPECT_FALSE(unrefracted.on);
    EXPECT_NE(unrefracted.why.find("nothing is refracted"), std::string::npos) << unrefracted.why;
}

TEST(Dispersion, IsNothingAtTheReferenceWavelength) {
    EXPECT_EQ(f64::dispersionTerm(0.5876), 0.0);
    EXPECT_GT(f64::dispersionTerm(0.45), 0.0);
    EXPECT_EQ(f64::dispersedIndex(1.5, 0.02, f64::dispersionTerm(0.5876)), 1.5);
    // Schott BK7: 1.5168 at d; 1.5224 at F and 1.5143 at C from its catalogue; Cauchy's two terms follow to a few 1e-4
    EXPECT_NEAR(f64::dispersedIndex(1.5168, 0.0042, f64::dispersionTerm(0.4861)), 1.5224, 3e-4);
    EXPECT_NEAR(f64::dispersedIndex(1.5168, 0.0042, f64::dispersionTerm(0.6563)), 1.5143, 3e-4);
}

} // namespace
} // namespace eikonal
