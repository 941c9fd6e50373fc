#pragma once
// Last step: the film of a tile as display-encoded values.

#include "common/scene.h"
#include "viewer/ray_batch.h"

namespace eikonal::viewer {

class ToneMapper {
public:
    ToneMapper(const gpu::Context& context, ToneMap curve, std::size_t capacity);

    /// Reads the film that `Accumulate` has bound.
    void run(const RayBatch& batch) const;
    /// sRGB-encoded values from 0 to 1 of a tile of that many pixels.
    std::vector<glm::vec4> display(std::size_t pixels) const { return display_.download<glm::vec4>(pixels); }

private:
    gpu::Kernel kernel_;
    gpu::Buffer display_;
};

} // namespace eikonal::viewer
