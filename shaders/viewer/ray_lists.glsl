// Lists of rays under way: a dispatch takes those of one list, so that its vectors hold none that have nothing to do, and fills the
// other with those that are to go on.
#include "shared/view_blocks.h"

layout(std430, binding = kStorageTakenRays) readonly buffer TakenRays {
    RayListHead takenHead;
    uint takenRays[];
};
layout(std430, binding = kStorageFilledRays) buffer FilledRays {
    RayListHead filledHead;
    uint filledRays[];
};

// Set in an entry: nothing happens to the ray in its next step that is known yet. Without it that step has been looked at, and
// needs care.
const uint kIsPlain = 0x80000000u;

void listRay(uint entry) {
    uint place = atomicAdd(filledHead.count, 1u);
    filledRays[place] = entry;
    if (place % uint(kRaysPerGroup) == 0u) {
        atomicAdd(filledHead.groups[0], 1u);
    }
}

// Whether there is a ray on the list for this invocation, and which.
bool isListed() {
    return gl_GlobalInvocationID.x < takenHead.count;
}

uint listedEntry() {
    return takenRays[gl_GlobalInvocationID.x];
}
