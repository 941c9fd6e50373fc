// Slabs whose radiance is known, from the scene file to the pixel: bake and image by `eikonal render`.
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "common/image_io.h"
#include "tests/tools/run_eikonal.h"

namespace eikonal::test {

namespace {

constexpr double kThickness = 0.75;

/// A slab across the view, with nothing else to see; edges of voxels are its faces.
std::string slabScene(const std::string& matter, const std::string& light) {
    return fmt::format(R"([domain]
resolution = 64
[[object]]
shape = "box"
size = [2, 2, {}]
ior = 1.0
{}
{}
[camera]
position = [0, 0, 30]
fov = 0.2
[environment]
color = [0, 0, 0]
[render]
size = [4, 4]
)",
                       kThickness, matter, light);
}

glm::dvec3 middleOf(const std::string& scene) {
    const TemporaryFolder folder;
    const RunResult result =
        runEikonal({"render", folder.write("scene.toml", scene), "-o", folder.file("slab.exr"), "--quiet"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return result.exitCode == 0 ? glm::dvec3(readImage(folder.file("slab.exr")).at(2, 2)) : glm::dvec3(0.0);
}

/// Henyey and Greenstein's phase function, per steradian.
double phase(double cosine, double g) {
    return (1.0 - g * g) / (4.0 * std::numbers::pi * std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
}

/// What a slab of extinction `sigma` scatters towards the camera of a beam with `cosine` of the angle between its travel and
/// the way to the camera: the integral of sigma p exp(-sigma (way in + way out)).
double scattered(double sigma, double cosine, double g) {
    const double depth = sigma * kThickness, slant = 1.0 / std::abs(cosine);
    const double lit = cosine > 0.0 ? (std::exp(-depth) - std::exp(-depth * slant)) / (slant - 1.0)
                                    : (1.0 - std::exp(-depth * (slant + 1.0))) / (slant + 1.0);
    return phase(cosine, g) * lit;
}

} // namespace

class HenyeyGreensteinSlab : public testing::TestWithParam<double> {};

TEST_P(HenyeyGreensteinSlab, ScattersAsTheClosedFormSays) {
    const double sigma = 1.6, irradiance = 3.0, g = GetParam();
    for (const double cosine : {0.8, -0.6}) {
        const std::string scene =
            slabScene(fmt::format("scattering = {}\nanisotropy = {}", sigma, g),
                      fmt::format("[[light]]\ndirection = [{}, 0, {}]\nirradiance = [{}, 1, 1]",
                                  std::sqrt(1.0 - cosine * cosine), cosine, irradiance));
        const double exact = irradiance * scattered(sigma, cosine, g);
        // A bake's voxels hold means, which at the faces of the slab, cut in half there, are 1 % off.
        EXPECT_NEAR(middleOf(scene).r, exact, 0.02 * exact) << "cosine " << cosine;
    }
}

INSTANTIATE_TEST_SUITE_P(ThreeAnisotropies, HenyeyGreensteinSlab, testing::Values(-0.5, 0.3, 0.8));

TEST(HenyeyGreensteinSlabByBand, ScattersEachBandByItsOwn) {
    const double sigma = 1.6;
    const glm::dvec3 g(-0.5, 0.3, 0.8);
    for (const double cosine : {0.8, -0.6}) {
        const glm::dvec3 found = middleOf(slabScene(fmt::format("scattering = {}\nanisotropy = [{}, {}, {}]", sigma, g.r, g.g, g.b),
                                                    fmt::format("[[light]]\ndirection = [{}, 0, {}]",
                                                                std::sqrt(1.0 - cosine * cosine), cosine)));
        for (int band = 0; band < 3; ++band) {
            const double exact = scattered(sigma, cosine, g[band]);
            EXPECT_NEAR(found[band], exact, 0.02 * exact) << "cosine " << cosine;  // as above
        }
    }
}

TEST(EmissionColumn, GlowsAsTheClosedFormSays) {
    const glm::dvec3 emission(3.0, 2.0, 1.0), sigma(0.5, 2.0, 5.0);
    const glm::dvec3 clear = middleOf(slabScene("emission = [3, 2, 1]", ""));
    const glm::dvec3 absorbing = middleOf(slabScene("emission = [3, 2, 1]\nabsorption = [0.5, 2, 5]", ""));
    for (int band = 0; band < 3; ++band) {
        EXPECT_NEAR(clear[band], emission[band] * kThickness, 1e-4 * emission[band]);  // sums of a hundred floats
        const double exact = emission[band] / sigma[band] * (1.0 - std::exp(-sigma[band] * kThickness));
        // At the faces emission and absorption rise over a voxel together: second order in 5 x 1/32 of depth.
        EXPECT_NEAR(absorbing[band], exact, 3e-3 * exact);
    }
}

} // namespace eikonal::test
