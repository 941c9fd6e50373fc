#pragma once
// The rays that one round of dispatches works on, and the block that all stages read.

#include "common/gpu/objects.h"
#include "shaders/shared/view_blocks.h"

namespace eikonal::viewer {

struct RayBatch {
    gpu::ViewBlock view{};
    gpu::Buffer viewBuffer;
    gpu::Buffer rays;  ///< gpu::RayState

    RayBatch(const gpu::Context& context, std::size_t capacity)
        : viewBuffer(context, sizeof(gpu::ViewBlock), "view"), rays(context, capacity * sizeof(gpu::RayState), "rays") {}

    /// Uploads `view` and binds both buffers.
    void bind() {
        viewBuffer.upload(view);
        viewBuffer.bindUniform(gpu::kUniformView);
        rays.bindStorage(gpu::kStorageRays);
    }
    glm::uvec3 groups() const {
        return {(view.rayCount + gpu::kRaysPerGroup - 1) / gpu::kRaysPerGroup, 1, 1};
    }
};

} // namespace eikonal::viewer
