#pragma once
// The fields of a scene as light of one wavelength finds them.

#include <optional>
#include <string>

#include "common/effects.h"
#include "common/fields.h"
#include "common/spectrum.h"

namespace eikonal {

/// Ends of the spectrum: dispersing matter has its greatest index at the one, its least at the other.
inline constexpr double kShortestVisibleMicrons = 0.4, kLongestVisibleMicrons = 0.7;

/// Throws badInput where the index is not positive at a wavelength, naming `source`. Nothing to check where nothing
/// disperses.
void requireIndexAt(const Fields& fields, double wavelengthMicrons, const std::string& source);

/// Index, gradient and constants of a band, the same in all three components, and nothing that disperses any more.
Fields fieldsOfBand(const Fields& fields, const SpectralBand& band);

/// Cauchy's B over n - 1 [µm²] where that is the same everywhere, to the rounding of the grids; else nothing. Insets are not
/// asked: with any there is nothing.
std::optional<double> cauchyOverRefractivity(const Fields& fields);

/// True if a grid holds the same value in red, green and blue everywhere.
bool isGrey(const DenseGrid<glm::vec3>& grid);
/// The same of what an inset absorbs, scatters and reflects diffusely.
bool isGrey(const Inset& inset);

/// The bands that light is followed in besides the reference wavelength; none without dispersion.
std::vector<SpectralBand> spectralBandsOf(const Accuracy& accuracy, const EffectSet& effects);

} // namespace eikonal
