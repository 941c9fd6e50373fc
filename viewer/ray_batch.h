#pragma once
// The rays that one round of dispatches works on, and the block that all stages read.

#include "common/gpu/row_buffer.h"
#include "shaders/shared/view_blocks.h"

namespace eikonal::viewer {

struct RayBatch {
    gpu::ViewBlock view{};
    gpu::Buffer viewBuffer;
    gpu::RowBuffer rays;  ///< gpu::RayState
    gpu::Buffer lists;    ///< of rays under way (shaders/viewer/ray_lists.glsl)

    RayBatch(const gpu::Context& context, std::size_t capacity)
        : viewBuffer(context, sizeof(gpu::ViewBlock), "view"), rays(context, capacity * sizeof(gpu::RayState), "rays"),
          lists(context, gpu::kRayLists * (sizeof(gpu::RayListHead) + capacity * sizeof(gpu::uint)), "ray lists") {
        for (gpu::uint list = 0; list < gpu::kRayLists; ++list) clearList(list);
    }

    /// Uploads `view` and binds the buffers.
    void bind() {
        viewBuffer.upload(view);
        viewBuffer.bindUniform(gpu::kUniformView);
        bindRays(rays);
        lists.bindStorage(gpu::kStorageRayLists);
    }
    /// Rays for the kernels to work on, these or others.
    static void bindRays(const gpu::RowBuffer& rays) {
        rays.bindStorage(gpu::kStorageRays);
        rays.bindTexels(gpu::kUnitRays);
    }
    glm::uvec3 groups() const {
        return {(view.rayCount + gpu::kRaysPerGroup - 1) / gpu::kRaysPerGroup, 1, 1};
    }

    void clearList(gpu::uint list) {
        const gpu::RayListHead empty{{0, 1, 1}, 0};
        lists.uploadBytes(list * sizeof empty, &empty, sizeof empty);
    }
    /// Rays on a list; waits for the device.
    gpu::uint listedCount(gpu::uint list) const {
        gpu::RayListHead head{};
        lists.downloadBytes(list * sizeof head, &head, sizeof head);
        return head.count;
    }
};

} // namespace eikonal::viewer
