#pragma once
// Slices of the ways of rays, dispatch after dispatch, until none is under way.

#include <cstdint>

#include "viewer/ray_lists.h"

namespace eikonal::viewer {

/// Calls slice(i), which fills the list with the rays that go on, for 0, 1, … at most `most` of them.
template <class Slice>
void runSlices(const RayLists& lists, std::uint32_t most, const Slice& slice) {
    // Between looks at whether a ray is under way still, for which the device is waited for. Most rays pass a ball in four.
    constexpr std::uint32_t kSlicesAtATime = 4;
    for (std::uint32_t i = 0; i < most; ++i) {
        slice(i);
        if ((i + 1) % kSlicesAtATime == 0 && lists.filledCount() == 0) return;
    }
}

} // namespace eikonal::viewer
