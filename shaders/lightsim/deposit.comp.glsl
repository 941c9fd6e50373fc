// Deposit: the step of a patch leaves power x path length in the voxels that it sweeps (docs/physics.md, section 3).
// The swept volume, bilinear over the patch and linear along the step, is cut into blocks of at most a voxel, each sampled
// at eight points half a voxel apart. The points are splatted together with trilinear weights, clamped at the faces so that
// no power is lost: their hats overlap, and one sum per voxel costs a quarter of the atomic additions.
#include "lightsim/bake.glsl"
#include "fields/fields.glsl"
#include "lightsim/fixed_point.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

layout(std430, binding = BAKE_FLUX_BINDING) buffer FluxX { uvec2 fluxX[]; };
layout(std430, binding = BAKE_FLUX_BINDING + 1) buffer FluxY { uvec2 fluxY[]; };
layout(std430, binding = BAKE_FLUX_BINDING + 2) buffer FluxZ { uvec2 fluxZ[]; };
layout(std430, binding = BAKE_IRRADIANCE_BINDING) buffer Irradiance0 { uvec2 irradiance0[]; };
#if BANDS == 3
layout(std430, binding = BAKE_IRRADIANCE_BINDING + 1) buffer Irradiance1 { uvec2 irradiance1[]; };
layout(std430, binding = BAKE_IRRADIANCE_BINDING + 2) buffer Irradiance2 { uvec2 irradiance2[]; };
#endif

const float kBlockSide = 1.0;  // [voxels]
const int kMaxBlocks = 2;      // along each side
const float kTooLong = 1.15;   // longest sides: refine splits patches before they grow that long, unless they are weak
const int kNodes = 3;          // a block of that side reaches the hats of 3 voxels along each axis

struct Sweep {  // a patch over its last step
    vec3 before[4];
    vec3 after[4];
    vec3 share[4];
    vec4 lengths;  // of the corners' steps along their arcs [voxels]: the path length even where they bend or part
};

vec3 bilinear(vec3 corners[4], vec2 at) {
    return mix(mix(corners[0], corners[1], at.x), mix(corners[3], corners[2], at.x), at.y);
}

float bilinear(vec4 corners, vec2 at) {
    return mix(mix(corners.x, corners.y, at.x), mix(corners.w, corners.z, at.x), at.y);
}

int blocksFor(float sideVoxels) {
    return clamp(int(ceil(sideVoxels / kBlockSide - 0.01)), 1, kMaxBlocks);
}

void addAt(ivec3 voxel, vec3 powerLength, vec3 flux) {
    uint index = (uint(voxel.z - settings.slabBegin) * uint(domainSize.y) + uint(voxel.y)) * uint(domainSize.x) +
                 uint(voxel.x);
    ADD_FIXED(fluxX, index, fixedPoint(flux.x))
    ADD_FIXED(fluxY, index, fixedPoint(flux.y))
    ADD_FIXED(fluxZ, index, fixedPoint(flux.z))
    ADD_FIXED(irradiance0, index, fixedPoint(powerLength.x))
#if BANDS == 3
    ADD_FIXED(irradiance1, index, fixedPoint(powerLength.y))
    ADD_FIXED(irradiance2, index, fixedPoint(powerLength.z))
#endif
}

const int kPoints = 8;

// Points that are splatted together, in voxels from the first voxel's centre, and the lengths of path that they stand for.
struct Block {
    vec3 places[kPoints];
    float lengths[kPoints];  // [voxels]; 0 outside the domain
    vec3 base;               // voxel whose hat reaches all of them from below
};

void placePoint(inout Block block, int i, vec3 x, float lengthVoxels) {
    bool inside = all(greaterThanEqual(x, domainMin)) && all(lessThanEqual(x, domainMax));
    block.places[i] = (x - domainMin) / domainVoxel - 0.5;
    block.lengths[i] = inside ? lengthVoxels : 0.0;
    if (inside && lengthVoxels > 0.0) {
        block.base = min(block.base, floor(block.places[i]));
    }
}

// Eight points of a block of the sweep, a quarter of its sides about its middle.
Block blockOf(Sweep sweep, vec3 low, vec3 extent) {
    Block block;
    block.base = vec3(1.0e9);
    for (int i = 0; i < kPoints; ++i) {
        vec3 at = low + extent * mix(vec3(0.25), vec3(0.75), vec3(ivec3(i & 1, (i >> 1) & 1, i >> 2)));
        vec3 x = mix(bilinear(sweep.before, at.xy), bilinear(sweep.after, at.xy), at.z);
        placePoint(block, i, x, extent.z * bilinear(sweep.lengths, at.xy) / float(kPoints));
    }
    return block;
}

// A single point of a corner's own step.
Block cornerPoint(Sweep sweep, int corner, float at) {
    Block block;
    block.base = vec3(1.0e9);
    for (int i = 0; i < kPoints; ++i) {
        placePoint(block, i, mix(sweep.before[corner], sweep.after[corner], at), i == 0 ? 0.5 * sweep.lengths[corner] : 0.0);
    }
    return block;
}

// Sum over the points of length times the hat of a voxel, `node` voxels above the block's base.
float hatSum(Block block, vec3 node) {
    float sum = 0.0;
    for (int i = 0; i < kPoints; ++i) {
        // a sheared block may reach a tenth of a voxel beyond the last hat: its points are moved onto it
        vec3 place = min(block.places[i] - block.base, vec3(float(kNodes - 1)));
        vec3 hat = max(1.0 - abs(place - node), 0.0);
        sum += block.lengths[i] * hat.x * hat.y * hat.z;
    }
    return sum;
}

// Share of a voxel that light can be in.
float freeShare(ivec3 voxel) {
#ifdef EFFECT_OPAQUE
    return 1.0 - texelFetch(opaqueGrid, voxel, 0).a;
#else
    return 1.0;
#endif
}

ivec3 voxelOf(Block block, int node) {
    ivec3 offset = ivec3(node % kNodes, (node / kNodes) % kNodes, node / (kNodes * kNodes));
    return clamp(ivec3(block.base) + offset, ivec3(0), domainSize - 1);
}

vec3 offsetOf(int node) {
    return vec3(ivec3(node % kNodes, (node / kNodes) % kNodes, node / (kNodes * kNodes)));
}

// What makes up for the part of the hats that lies in opaque matter, where no light is.
float opaqueCompensation(Block block) {
    float correction = 1.0;
#ifdef EFFECT_OPAQUE
    float total = 0.0;
    float free = 0.0;
    for (int node = 0; node < kNodes * kNodes * kNodes; ++node) {
        float weight = hatSum(block, offsetOf(node));
        total += weight;
        free += weight * freeShare(voxelOf(block, node));
    }
    correction = free > 0.0 ? total / free : 0.0;
#endif
    return correction;
}

float longerOf(Sweep sweep, int a, int b, int c, int d) {
    return max(distance(sweep.after[a], sweep.after[b]), distance(sweep.after[c], sweep.after[d]));
}

vec3 meanDirection(vec3 along, float lengthVoxels) {
    return along / max(lengthVoxels * domainVoxel, 1.0e-30);
}

// A part of the sweep that is splatted at once.
struct Part {
    Block block;
    vec3 power;
    vec3 travel;  // mean direction, shorter than 1 where the corners' directions differ
};

// Of a patch too weak to be split: between its corners there may be anything. Each stands for a quarter of the power on its
// own path, two points of it.
Part cornerPart(Sweep sweep, vec3 power, int i) {
    int corner = i / 2;
    Part part;
    part.block = cornerPoint(sweep, corner, float(i % 2) * 0.5 + 0.25);
    part.power = 0.25 * power * sweep.share[corner];
    part.travel = meanDirection(sweep.after[corner] - sweep.before[corner], sweep.lengths[corner]);
    return part;
}

Part blockPart(Sweep sweep, vec3 power, ivec3 counts, int i) {
    vec3 extent = 1.0 / vec3(counts);
    vec3 low = extent * vec3(ivec3(i % counts.x, (i / counts.x) % counts.y, i / (counts.x * counts.y)));
    vec2 middle = low.xy + 0.5 * extent.xy;
    Part part;
    part.block = blockOf(sweep, low, extent);
    part.power = power * (extent.x * extent.y) * bilinear(sweep.share, middle);
    part.travel = meanDirection(bilinear(sweep.after, middle) - bilinear(sweep.before, middle),
                                bilinear(sweep.lengths, middle));
    return part;
}

void depositPart(Part part) {
    Block block = part.block;
    vec3 scaled = part.power * (settings.depositScale * opaqueCompensation(block));
#if BANDS == 3
    vec3 flux = part.travel * (scaled.x + scaled.y + scaled.z);
#else
    vec3 flux = part.travel * scaled.x;
#endif
    for (int node = 0; node < kNodes * kNodes * kNodes; ++node) {
        ivec3 voxel = voxelOf(block, node);
        float weight = hatSum(block, offsetOf(node)) * freeShare(voxel);
        if (weight > 0.0 && voxel.z >= settings.slabBegin && voxel.z < settings.slabEnd) {
            addAt(voxel, scaled * weight, flux * weight);
        }
    }
}

// One loop for both kinds of patches: their invocations run side by side.
void depositSweep(Sweep sweep, vec3 power) {
    float sideU = longerOf(sweep, 0, 1, 3, 2);
    float sideV = longerOf(sweep, 0, 3, 1, 2);
    float stepLength = max(max(sweep.lengths.x, sweep.lengths.y), max(sweep.lengths.z, sweep.lengths.w));
    ivec3 counts = ivec3(blocksFor(sideU / domainVoxel), blocksFor(sideV / domainVoxel), blocksFor(stepLength));
    bool tooLong = max(sideU, sideV) > kTooLong * settings.maxSide;
    int parts = tooLong ? 8 : counts.x * counts.y * counts.z;
    for (int i = 0; i < parts; ++i) {
        Part part = blockPart(sweep, power, counts, i);
        if (tooLong) {
            part = cornerPart(sweep, power, i);
        }
        depositPart(part);
    }
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= queue.liveCount) {
        return;
    }
    uint slot = liveSlot(index);
    Sweep sweep;
    for (int i = 0; i < 4; ++i) {
        sweep.before[i] = patches[slot].corners[i].xPrevious;
        sweep.after[i] = patches[slot].corners[i].x;
        sweep.share[i] = patches[slot].corners[i].meanShare;
        sweep.lengths[i] = patches[slot].corners[i].arcLength / domainVoxel;
    }
    depositSweep(sweep, patches[slot].power);
}
