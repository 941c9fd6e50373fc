#pragma once
// Into what portions the marching of a picture is divided.

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "common/gpu/context.h"
#include "shaders/shared/reflection_blocks.h"

namespace eikonal::viewer {

struct Portions {
    std::size_t rays;                ///< under way at a time: bounds the memory
    std::uint32_t stepsOfSlice;      ///< of one ray in one dispatch, at most
    std::uint32_t stepsOfDispatch;   ///< of all its rays together
    std::uint32_t loopsOfSlice;      ///< iterations that one invocation may go through
    std::uint32_t fewRays;           ///< do not fill the device, and are not listed anew after each event
    std::uint32_t blocksInTurn;      ///< of rays that a workgroup draws one after the other, a slice of each
};

/// Mesa's software renderer ends loops silently after 65535 iterations of an invocation, nested loops included; a vector of
/// eight rays has one count, and in the worst case they take their turns one after the other.
inline constexpr std::uint32_t kLoopsOnProcessor = 65535 / 8;

/// A vector of a processor waits for its last ray, so that rays that have ended are taken out soon. A GPU waits for the longest
/// ray of every dispatch, however many go beside it; one that takes a hundred million steps a second, a small one in smoke, is
/// done with a dispatch before a driver's watchdog wakes. To begin a kernel takes a processor as long as some steps of a vector;
/// a GPU has invocations for all blocks. What waits at a ray's boundaries must fit a storage block.
inline Portions portionsFor(const gpu::DeviceLimits& limits) {
    if (limits.isProcessor) return {1u << 17, 192, 1u << 28, kLoopsOnProcessor, 1024, 4};
    const std::size_t rays = std::min<std::size_t>(1u << 19, limits.maxStorageBlockBytes / sizeof(gpu::PixelReflections));
    return {rays, 4096, 1u << 28, ~0u, std::uint32_t(rays), 1};
}

/// `asked`, or where that is 0 as many as the device likes.
inline std::size_t raysAtATime(std::size_t asked, const gpu::DeviceLimits& limits) {
    return asked > 0 ? asked : portionsFor(limits).rays;
}

} // namespace eikonal::viewer
