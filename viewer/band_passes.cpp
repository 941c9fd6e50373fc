#include "viewer/band_passes.h"

#include <numbers>

#include "common/physics.h"

namespace eikonal::viewer {

void BandPasses::configure(gpu::ViewBlock& view, bool everyRayByBand) {
    everyRayByBand_ = everyRayByBand;
    view.bandChannel = gpu::kAllChannels;
}

/// A band is an interval, and samples are its strata: few bands with many samples show no steps. The strata are dealt out
/// differently in each band, so that no place within the pixel gets the long wavelengths of all of them. Where their number is
/// not known, the golden ratio spreads any number of them.
double BandPasses::placeInBand(std::size_t index, int sample) const {
    const int place = sample + int(index);
    if (samples_ == 0) return glm::fract(0.5 + place / std::numbers::phi);
    return (place % samples_ + 0.5) / samples_;
}

void BandPasses::begin(std::size_t pass, int sample, gpu::ViewBlock& view, GpuFields& fields, const Light& light) const {
    if (bands_.empty()) return;
    if (pass == 0) {
        view.bandChannel = gpu::kAllChannels;
        view.dispersedAtStart = everyRayByBand_ ? 1u : 0u;
        fields.setWavelength(f64::kReferenceMicrons);
        light.bind();
        return;
    }
    const std::size_t index = pass - 1;
    const SpectralBand& band = bands_[index];
    view.bandChannel = gpu::uint(band.channel);
    view.bandToRgb = glm::vec3(band.toRgb);
    view.dispersedAtStart = 1u;
    fields.setWavelength(band.wavelengthAt(placeInBand(index, sample)));
    light.bindBand(index);
}

} // namespace eikonal::viewer
