#pragma once
// The rays that one round of dispatches works on, and the block that all stages read.

#include "common/gpu/row_buffer.h"
#include "shaders/shared/view_blocks.h"
#include "viewer/ray_lists.h"

namespace eikonal::viewer {

struct RayBatch {
    gpu::ViewBlock view{};
    gpu::Buffer viewBuffer;
    gpu::RowBuffer rays;  ///< gpu::RayState
    RayLists lists;

    RayBatch(const gpu::Context& context, std::size_t capacity)
        : viewBuffer(context, sizeof(gpu::ViewBlock), "view"), rays(context, capacity * sizeof(gpu::RayState), "rays"),
          lists(context, capacity) {}

    /// Uploads `view` and binds the buffers.
    void bind() {
        viewBuffer.upload(view);
        viewBuffer.bindUniform(gpu::kUniformView);
        bindRays(rays);
        lists.bind();
    }
    /// Rays for the kernels to work on, these or others.
    static void bindRays(const gpu::RowBuffer& rays) {
        rays.bindStorage(gpu::kStorageRays);
        rays.bindTexels(gpu::kUnitRays);
    }
    glm::uvec3 groups() const {
        return {(view.rayCount + gpu::kRaysPerGroup - 1) / gpu::kRaysPerGroup, 1, 1};
    }
};

} // namespace eikonal::viewer
