#pragma once
// Last step: the film as display-encoded values.

#include <string>
#include <vector>

#include "common/scene.h"
#include "viewer/ray_batch.h"

namespace eikonal::viewer {

/// What kernels that include physics/tone.glsl are compiled with for a curve.
std::vector<std::string> toneDefines(ToneMap curve);

class ToneMapper {
public:
    ToneMapper(const gpu::Context& context, ToneMap curve);

    /// Room for that many pixels at least.
    void reserve(const gpu::Context& context, std::size_t pixels);

    /// Reads the film that `Accumulate` has bound.
    void run(const RayBatch& batch) const;
    /// sRGB-encoded values from 0 to 1 of the first pixels.
    std::vector<glm::vec4> display(std::size_t pixels) const { return display_.download<glm::vec4>(pixels); }
    std::size_t displayBytes() const { return display_.bytes(); }

private:
    gpu::Kernel kernel_;
    gpu::Buffer display_;
};

} // namespace eikonal::viewer
