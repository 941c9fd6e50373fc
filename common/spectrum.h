#pragma once
// The bands that stand for the visible spectrum where matter disperses light, and what they are as colours
// (docs/physics.md, section 6).

#include <vector>

#include <glm/glm.hpp>

namespace eikonal {

/// A share of the spectrum. Its light is measured relative to white: an equal value in all bands is white.
struct SpectralBand {
    double wavelengthMicrons = 0.0;  ///< half of the band's stimulus lies on either side
    int channel = 0;                 ///< of linear Rec.709 constants: the one that holds in the band
    glm::dvec3 toRgb{0.0};           ///< linear Rec.709 of a unit of light in the band; over all bands they sum to 1, 1, 1
    double begin = 0.0, end = 1.0;   ///< the band as shares of its channel's stimulus, from short wavelengths to long

    /// The wavelength below which a share from 0 to 1 of the band's stimulus lies; 1/2: wavelengthMicrons.
    double wavelengthAt(double share) const;
    double wavelengthNm() const { return 1000.0 * wavelengthMicrons; }
};

/// `count` bands, 3 or more, from long wavelengths to short. Three are R, G, B themselves.
std::vector<SpectralBand> spectralBands(int count);

/// Linear Rec.709 of light that is given by band, in the order of the bands.
glm::dvec3 rgbOf(const std::vector<SpectralBand>& bands, const std::vector<double>& light);

} // namespace eikonal
