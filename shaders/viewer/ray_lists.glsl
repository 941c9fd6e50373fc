// Lists of rays under way: a dispatch takes the rays of one list, so that its vectors hold none that have nothing to do.
#include "shared/view_blocks.h"

layout(std430, binding = kStorageRayLists) buffer RayLists {
    RayListHead heads[kRayLists];
    uint listed[];
};

// Set in an entry of kEventfulRays: nothing happens to the ray, whose slice has ended. It goes on in the next one.
const uint kSliceEnded = 0x80000000u;

void listRay(uint list, uint index) {
    uint place = atomicAdd(heads[list].count, 1u);
    listed[kRayLists * place + list] = index;
    if (place % uint(kRaysPerGroup) == 0u) {
        atomicAdd(heads[list].groups[0], 1u);
    }
}

// Whether there is a ray on the list for this invocation, and which.
bool isListed(uint list) {
    return gl_GlobalInvocationID.x < heads[list].count;
}

uint listedRay(uint list) {
    return listed[kRayLists * gl_GlobalInvocationID.x + list];
}
