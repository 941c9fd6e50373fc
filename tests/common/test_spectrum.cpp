// The bands that stand for the spectrum: white stays white, constants come back, colours are those of the CIE functions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "common/spectrum.h"

namespace eikonal {
namespace {

constexpr double kRounding = 1e-12;  // sums of some dozens of numbers of the order of 1

void expectNear(const glm::dvec3& found, const glm::dvec3& expected, double tolerance) {
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(found[channel], expected[channel], tolerance) << "channel " << channel;
}

class Spectrum : public ::testing::TestWithParam<int> {
protected:
    const std::vector<SpectralBand> bands = spectralBands(GetParam());
};

TEST_P(Spectrum, EqualLightInAllBandsIsWhite) {
    expectNear(rgbOf(bands, std::vector<double>(bands.size(), 1.0)), glm::dvec3(1.0), kRounding);
}

TEST_P(Spectrum, ColoursComeBack) {
    const glm::dvec3 colour(0.9, 0.05, 0.4);
    std::vector<double> light;
    for (const SpectralBand& band : bands)
        light.push_back(colour[band.channel]);
    expectNear(rgbOf(bands, light), colour, kRounding);
}

TEST_P(Spectrum, BandsLieSideBySideFromRedToBlue) {
    for (std::size_t i = 0; i < bands.size(); ++i) {
        EXPECT_LT(bands[i].wavelengthAt(0.0), bands[i].wavelengthMicrons);
        EXPECT_LT(bands[i].wavelengthMicrons, bands[i].wavelengthAt(1.0));
        if (i > 0) {
            EXPECT_NEAR(bands[i].wavelengthAt(1.0), bands[i - 1].wavelengthAt(0.0), 1e-9);
        }
    }
    EXPECT_NEAR(bands.front().wavelengthAt(1.0), 0.7, 1e-9);
    EXPECT_NEAR(bands.back().wavelengthAt(0.0), 0.4, 1e-9);
}

TEST_P(Spectrum, GridsOfBandsHaveNamesOfTheirOwn) {
    std::set<long> names;
    for (const SpectralBand& band : bands)
        names.insert(std::lround(band.wavelengthNm()));
    EXPECT_EQ(names.size(), bands.size());
}

INSTANTIATE_TEST_SUITE_P(OfManyBands, Spectrum, ::testing::Values(3, 4, 5, 8, 16, 32),
                         [](const auto& count) { return "With" + std::to_string(count.param); });

TEST(SpectrumOfThree, IsRedGreenAndBlue) {
    const auto bands = spectralBands(3);
    for (int channel = 0; channel < 3; ++channel) {
        glm::dvec3 primary(0.0);
        primary[channel] = 1.0;
        EXPECT_EQ(bands[std::size_t(channel)].channel, channel);
        expectNear(bands[std::size_t(channel)].toRgb, primary, kRounding);
    }
}

TEST(SpectrumOfMany, IsBrightestAtTheGreenOfTheLuminosityFunction) {
    const auto bands = spectralBands(48);
    double brightest = 0.0, wavelength = 0.0;
    for (const SpectralBand& band : bands) {
        const double width = band.wavelengthAt(1.0) - band.wavelengthAt(0.0);
        const double luminance = glm::dot(glm::dvec3(0.2126, 0.7152, 0.0722), band.toRgb) / width;
        if (luminance > brightest)
            brightest = luminance, wavelength = band.wavelengthNm();
    }
    // 555 nm is the peak by daylight vision; D65 leans to shorter wavelengths, and a band is some 5 nm wide.
    EXPECT_NEAR(wavelength, 552.0, 10.0);
}

TEST(SpectrumOfMany, PureSpectralColoursLieOutsideTheDisplaysGamut) {
    for (const SpectralBand& band : spectralBands(32)) {
        const double least = std::min({band.toRgb.r, band.toRgb.g, band.toRgb.b});
        const double most = std::max({band.toRgb.r, band.toRgb.g, band.toRgb.b});
        EXPECT_GT(most, 0.0);
        // Between the red primary and the end of the spectrum colours are as saturated as the display's own.
        if (band.wavelengthNm() < 590.0) {
            EXPECT_LT(least, 0.0) << band.wavelengthNm();
        }
    }
}

} // namespace
} // namespace eikonal
