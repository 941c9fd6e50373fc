#include "viewer/band_passes.h"

#include "common/physics.h"

namespace eikonal::viewer {

void BandPasses::configure(gpu::ViewBlock& view, bool everyRayByBand) {
    everyRayByBand_ = everyRayByBand;
    view.bandChannel = gpu::kAllChannels;
}

/// A band is an interval, and samples are its strata: few bands with many samples show no steps. The strata are dealt out
/// differently in each band, so that no place within the pixel gets the long wavelengths of all of them.
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
    const int stratum = (sample + int(index)) % samples_;
    fields.setWavelength(band.wavelengthAt((stratum + 0.5) / samples_));
    light.bindBand(index);
}

} // namespace eikonal::viewer
