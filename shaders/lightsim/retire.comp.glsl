// Retire: patches that are done leave the pool. Only here does their story, which every corner has kept since its launch,
// become part of the ledger: the parents of split patches never enter it.
#include "lightsim/bake.glsl"
#include "lightsim/ledger.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= queue.retireCount) {
        return;
    }
    uint slot = slotLists[RETIRE_LIST * settings.capacity + index];
    enterPatch(patches[slot]);
    returnSlot(slot);
}
