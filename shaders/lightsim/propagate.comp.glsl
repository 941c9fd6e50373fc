// Propagate: every corner of every live patch advances one step of optical path (Eqs. 4.12, 4.13 of the 2007 thesis in
// the form of docs/physics.md, section 1).
#include "lightsim/bake.glsl"
#include "lightsim/particle.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= 4u * queue.liveCount) {
        return;
    }
    uint slot = liveSlot(index / 4u);
    uint corner = index % 4u;
    float t = float(patches[slot].stepCount) * settings.opticalStep;
    patches[slot].corners[corner] = advance(patches[slot].corners[corner], t);
}
