#pragma once
// Rays under way (shaders/viewer/ray_lists.glsl): a dispatch takes the rays of one list and fills the other.

#include <utility>
#include <vector>

#include "common/gpu/objects.h"
#include "shaders/shared/view_blocks.h"

namespace eikonal::viewer {

class RayLists {
public:
    /// Both empty. `capacity`: rays.
    RayLists(const gpu::Context& context, std::size_t capacity)
        : taken_(context, bytesFor(capacity), "rays taken"), filled_(context, bytesFor(capacity), "rays filled") {
        clear(taken_);
        clear(filled_);
    }

    void bind() const {
        taken_.bindStorage(gpu::kStorageTakenRays);
        filled_.bindStorage(gpu::kStorageFilledRays);
    }
    void clearFilled() { clear(filled_); }
    /// To be filled by a kernel of so many workgroups whose invocations have places of their own, which may stay empty.
    void fillByGroups(gpu::uint groups) {
        const gpu::uint places = groups * gpu::kRaysPerGroup;
        filled_.grow(bytesFor(places));
        filled_.upload(gpu::RayListHead{{groups, 1, 1}, places});
        bind();
    }
    /// The list that was filled is taken next, and the other filled from the start.
    void swap() {
        std::swap(taken_, filled_);
        clear(filled_);
        bind();
    }
    /// Dispatches a kernel over the rays that are taken.
    void dispatch(const gpu::Kernel& kernel) const { kernel.dispatchIndirect(taken_, 0); }
    /// Places, empty ones included. Waits for the device.
    gpu::uint filledCount() const {
        gpu::RayListHead head{};
        filled_.downloadBytes(0, &head, sizeof head);
        return head.count;
    }
    /// Indices of the rays on it, in its order. Waits for the device.
    std::vector<gpu::uint> filledRays() const {
        std::vector<gpu::uint> rays(filledCount());
        filled_.downloadBytes(sizeof(gpu::RayListHead), rays.data(), rays.size() * sizeof(gpu::uint));
        std::erase(rays, gpu::kNoEntry);
        for (gpu::uint& ray : rays) ray &= ~gpu::kIsPlain;
        return rays;
    }
    std::size_t bytes() const { return taken_.bytes() + filled_.bytes(); }

private:
    static std::size_t bytesFor(std::size_t capacity) { return sizeof(gpu::RayListHead) + capacity * sizeof(gpu::uint); }
    static void clear(gpu::Buffer& list) { list.upload(gpu::RayListHead{{0, 1, 1}, 0}); }

    gpu::Buffer taken_, filled_;
};

} // namespace eikonal::viewer
