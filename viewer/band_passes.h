#pragma once
// The passes in which the rays of a sample are followed: all of them at the reference wavelength; then, where something
// disperses, those that have met it, once for every band (shaders/viewer/ray_states.glsl).

#include <vector>

#include "common/gpu_fields.h"
#include "common/spectrum.h"
#include "shaders/shared/view_blocks.h"
#include "viewer/light.h"

namespace eikonal::viewer {

class BandPasses {
public:
    /// No bands: the reference pass is all there is. `samples`: of each pixel; 0: nobody knows how many there will be.
    BandPasses(std::vector<SpectralBand> bands, int samples) : bands_(std::move(bands)), samples_(samples) {}

    std::size_t bandCount() const { return bands_.size(); }
    std::size_t count() const { return 1 + bands_.size(); }
    /// `everyRayByBand`: also rays that meet no dispersion, where coloured matter scatters light that differs by band.
    void configure(gpu::ViewBlock& view, bool everyRayByBand);
    /// Sets wavelength, channel and light of a pass, 0 the reference.
    void begin(std::size_t pass, int sample, gpu::ViewBlock& view, GpuFields& fields, const Light& light) const;

private:
    /// Where in a band a sample is, 0 to 1.
    double placeInBand(std::size_t index, int sample) const;

    std::vector<SpectralBand> bands_;
    int samples_;
    bool everyRayByBand_ = false;
};

} // namespace eikonal::viewer
