#include "common/spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace eikonal {

namespace {

constexpr double kStepNm = 0.5;  // of integrals over wavelength

/// The wavelengths in which red, green and blue constants hold [nm]. Boxes with these edges have colours within 0.06 of
/// the primaries of Rec.709: no other two edges between 400 and 700 nm come nearer by more than 0.001.
struct Box {
    double low, high;
};
constexpr std::array<Box, 3> kBoxes{{{592.0, 700.0}, {490.0, 592.0}, {400.0, 490.0}}};

double lobe(double x, double mean, double inverseWidthBelow, double inverseWidthAbove) {
    const double t = (x - mean) * (x < mean ? inverseWidthBelow : inverseWidthAbove);
    return std::exp(-0.5 * t * t);
}

/// The CIE 1931 colour matching functions by C. Wyman, P.-P. Sloan, P. Shirley, Simple Analytic Approximations to the CIE
/// XYZ Color Matching Functions, JCGT 2(2), 2013, multi-lobe fit.
glm::dvec3 cieXyz(double nm) {
    return {0.362 * lobe(nm, 442.0, 0.0624, 0.0374) + 1.056 * lobe(nm, 599.8, 0.0264, 0.0323) -
                0.065 * lobe(nm, 501.1, 0.0490, 0.0382),
            0.821 * lobe(nm, 568.8, 0.0213, 0.0247) + 0.286 * lobe(nm, 530.9, 0.0613, 0.0322),
            1.217 * lobe(nm, 437.0, 0.0845, 0.0278) + 0.681 * lobe(nm, 459.0, 0.0385, 0.0725)};
}

/// Relative power of CIE standard illuminant D65 (ISO/CIE 11664-2), the white of Rec.709; every 10 nm from 400 to 700 nm,
/// linear between.
double illuminantD65(double nm) {
    static constexpr std::array kTable{
        82.7549, 91.4860, 93.4318, 86.6823, 104.865, 117.008, 117.812, 114.861, 115.923, 108.811, 109.354,
        107.802, 104.790, 107.689, 104.405, 104.046, 100.000, 96.3342, 95.7880, 88.6856, 90.0062, 89.5991,
        87.6987, 83.2886, 83.6992, 80.0268, 80.2146, 82.2778, 78.2842, 69.7213, 71.6091};
    const double place = std::clamp((nm - 400.0) / 10.0, 0.0, double(kTable.size() - 1));
    const std::size_t below = std::min(std::size_t(place), kTable.size() - 2);
    return std::lerp(kTable[below], kTable[below + 1], place - double(below));
}

/// What a wavelength of white light does to the eye: to all three kinds of cones together it is its stimulus.
glm::dvec3 tristimulus(double nm) { return cieXyz(nm) * illuminantD65(nm); }

double stimulus(double nm) {
    const glm::dvec3 xyz = tristimulus(nm);
    return xyz.x + xyz.y + xyz.z;
}

/// Stimulus of a channel's box up to the ends of its steps, as a share of all of it.
std::vector<double> stimulusUpTo(const Box& box) {
    std::vector<double> sums{0.0};
    for (double nm = box.low; nm < box.high; nm += kStepNm) {
        sums.push_back(sums.back() + stimulus(nm + 0.5 * kStepNm));
    }
    for (double& sum : sums) {
        sum /= sums.back();
    }
    return sums;
}

/// The wavelength below which a share of a channel's stimulus lies [nm].
double wavelengthBelow(int channel, double share) {
    static const std::array kSums{stimulusUpTo(kBoxes[0]), stimulusUpTo(kBoxes[1]), stimulusUpTo(kBoxes[2])};
    const std::vector<double>& sums = kSums[std::size_t(channel)];
    const auto above = std::upper_bound(sums.begin() + 1, sums.end() - 1, share);
    const double before = *(above - 1);
    const double steps = double(above - sums.begin()) - 1.0 + (share - before) / (*above - before);
    return kBoxes[std::size_t(channel)].low + kStepNm * std::clamp(steps, 0.0, double(sums.size() - 1));
}

/// Linear Rec.709 by the CIE functions, up to a common factor (ITU-R BT.709 primaries, white D65; matrix by columns).
glm::dvec3 cieRgb(const SpectralBand& band) {
    static const glm::dmat3 kRgbFromXyz{{3.2404542, -0.9692660, 0.0556434},
                                        {-1.5371385, 1.8760108, -0.2040259},
                                        {-0.4985314, 0.0415560, 1.0572252}};
    constexpr int kSamples = 64;  // midpoints: curves change little over a 64th of a band
    const double low = wavelengthBelow(band.channel, band.begin), high = wavelengthBelow(band.channel, band.end);
    glm::dvec3 xyz(0.0);
    for (int i = 0; i < kSamples; ++i) {
        xyz += tristimulus(std::lerp(low, high, (i + 0.5) / kSamples)) * ((high - low) / kSamples);
    }
    return kRgbFromXyz * xyz;
}

/// Bands of a channel when there are `count` in all: a third, those left over to green and blue.
int bandsIn(int channel, int count) { return count / 3 + (channel == 1 && count % 3 > 0) + (channel == 2 && count % 3 > 1); }

std::vector<SpectralBand> bandsWithoutColour(int count) {
    std::vector<SpectralBand> bands;
    for (int channel = 0; channel < 3; ++channel) {
        const int inChannel = bandsIn(channel, count);
        for (int i = inChannel - 1; i >= 0; --i) {
            SpectralBand band{.channel = channel, .begin = double(i) / inChannel, .end = double(i + 1) / inChannel};
            band.wavelengthMicrons = band.wavelengthAt(0.5);
            bands.push_back(band);
        }
    }
    return bands;
}

} // namespace

double SpectralBand::wavelengthAt(double share) const {
    return 1e-3 * wavelengthBelow(channel, std::lerp(begin, end, share));
}

/// A constant (r, g, b) is r in the bands of the first channel and so on. For the colours of the bands to give it back, those
/// of a channel must sum to its primary: the inverse of the boxes' colours sees to that.
std::vector<SpectralBand> spectralBands(int count) {
    if (count < 3) {
        throw std::logic_error("a spectrum of fewer than 3 bands has no white");
    }
    std::vector<SpectralBand> bands = bandsWithoutColour(count);
    glm::dmat3 colourOfBox(0.0);
    for (SpectralBand& band : bands) {
        band.toRgb = cieRgb(band);
        colourOfBox[band.channel] += band.toRgb;
    }
    const glm::dmat3 primaryFromBox = glm::inverse(colourOfBox);
    for (SpectralBand& band : bands) {
        band.toRgb = primaryFromBox * band.toRgb;
    }
    return bands;
}

glm::dvec3 rgbOf(const std::vector<SpectralBand>& bands, const std::vector<double>& light) {
    glm::dvec3 rgb(0.0);
    for (std::size_t i = 0; i < bands.size(); ++i) {
        rgb += bands[i].toRgb * light[i];
    }
    return rgb;
}

} // namespace eikonal
