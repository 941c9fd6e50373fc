#pragma once
// How far off the refined picture may be: it is compared with one of half its accuracy, whose rays take steps of twice the
// length, whose pixels have half the samples, and whose light is baked at twice the tolerance. What halves at least with each
// of these is off by no more than the two differ.

#include <optional>

#include "common/fields.h"
#include "viewer/image.h"

namespace eikonal::window {

class ErrorEstimate {
public:
    /// `light`: the light of twice the tolerance, or nullptr for none. Keeps a reference to the context.
    ErrorEstimate(const gpu::Context& context, const Scene& scene, const Fields& fields, const EffectSet& effects,
                  const BakedLight* light, const glm::ivec2& size);

    /// Follows the next rays of the picture to compare with.
    void addRays(std::size_t most) { image_.addRays(most); }
    bool isDone() const { return image_.samples() >= samples_; }
    const ProgressiveImage& image() const { return image_; }
    /// Sum over the picture of the differences of radiance, as a share of the sum of radiances.
    double differenceFrom(const ProgressiveImage& picture) const;

private:
    ProgressiveImage image_;
    int samples_;
};

/// The same of two bakes: of irradiance, over all voxels. The lattices must be the same.
double differenceOf(const BakedLight& light, const BakedLight& other);

} // namespace eikonal::window
