// Deposit, of patches that are too weak to be split and have grown too long to be interpolated: between their corners there
// may be anything, so each corner stands for a quarter of the power on its own path. Four invocations a patch.
#include "lightsim/splat.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

const int kPoints = 2;  // along the step, at most half a voxel apart

struct Stencil {  // the eight voxels whose hats reach a point
    ivec3 voxels[8];
    float weights[8];
};

Stencil stencilAt(vec3 x) {
    vec3 place = (x - domain.min) / domain.voxel - 0.5;
    vec3 lower = floor(place);
    vec3 fraction = place - lower;
    Stencil stencil;
    float free = 0.0;
    for (int i = 0; i < 8; ++i) {
        ivec3 offset = ivec3(i & 1, (i >> 1) & 1, i >> 2);
        vec3 hat = mix(1.0 - fraction, fraction, vec3(offset));
        stencil.voxels[i] = clamp(ivec3(lower) + offset, ivec3(0), domain.size - 1);
        stencil.weights[i] = hat.x * hat.y * hat.z * freeShare(stencil.voxels[i]);
        free += stencil.weights[i];
    }
    for (int i = 0; i < 8; ++i) {
        stencil.weights[i] *= free > 0.0 ? 1.0 / free : 0.0;
    }
    return stencil;
}

void splat(vec3 x, vec3 powerLength, vec3 travel) {
    if (any(lessThan(x, domain.min)) || any(greaterThan(x, domain.max))) {
        return;
    }
    Stencil stencil = stencilAt(x);
    vec3 flux = fluxOf(powerLength, travel);
    for (int i = 0; i < 8; ++i) {
        addAt(stencil.voxels[i], powerLength * stencil.weights[i], flux * stencil.weights[i]);
    }
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= 4u * queue.cornersCount) {
        return;
    }
    uint slot = slotLists[CORNERS_LIST * settings.capacity + index / 4u];
    Particle corner = patches[slot].corners[index % 4u];
    vec3 along = corner.x - corner.xPrevious;
    vec3 travel = along / max(corner.arcLength, 1.0e-30);
    vec3 powerLength = 0.25 * patches[slot].power * corner.meanShare *
                       (settings.depositScale * corner.arcLength / (domain.voxel * float(kPoints)));
    for (int i = 0; i < kPoints; ++i) {
        splat(corner.xPrevious + along * ((float(i) + 0.5) / float(kPoints)), powerLength, travel);
    }
}
