// Deposit: the step of a patch leaves power x path length in the voxels that it sweeps (docs/physics.md, section 3).
// The swept volume, bilinear over the patch and linear along the step, is cut into blocks of at most a voxel, each sampled
// at eight points half a voxel apart. The points are splatted together with trilinear weights, clamped at the faces so that
// no power is lost: their hats overlap, and one sum per voxel costs a quarter of the atomic additions. Patches too long for
// that are listed for deposit_corners.
#include "lightsim/splat.glsl"
#include "lightsim/sweep.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

const float kBlockSide = 1.0;  // [voxels]
const int kMaxBlocks = 2;      // along each side
const float kTooLong = 1.15;   // longest sides: refine splits patches before they grow that long, unless they are weak
const int kNodes = 3;          // a block of that side reaches the hats of 3 voxels along each axis

int blocksFor(float sideVoxels) {
    return clamp(int(ceil(sideVoxels / kBlockSide - 0.01)), 1, kMaxBlocks);
}

const int kPoints = 8;

// Points that are splatted together, in voxels from the first voxel's centre, and the lengths of path that they stand for.
struct Block {
    vec3 places[kPoints];
    float lengths[kPoints];  // [voxels]; 0 outside the domain
    vec3 base;               // voxel whose hat reaches all of them from below
};

void placePoint(inout Block block, int i, vec3 x, float lengthVoxels) {
    bool inside = all(greaterThanEqual(x, domain.min)) && all(lessThanEqual(x, domain.max));
    block.places[i] = (x - domain.min) / domain.voxel - 0.5;
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

ivec3 voxelOf(Block block, int node) {
    ivec3 offset = ivec3(node % kNodes, (node / kNodes) % kNodes, node / (kNodes * kNodes));
    return clamp(ivec3(block.base) + offset, ivec3(0), domain.size - 1);
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

vec3 meanDirection(vec3 along, float lengthVoxels) {
    return along / max(lengthVoxels * domain.voxel, 1.0e-30);
}

// A part of the sweep that is splatted at once.
struct Part {
    Block block;
    vec3 power;
    vec3 travel;  // mean direction, shorter than 1 where the corners' directions differ
};

// Mean share over a block about a place of the sweep. Matter makes it fall exponentially across a patch that enters it
// obliquely: the value in the middle is the geometric mean of what lies about it, and Simpson's rule with the corners'
// arithmetic mean gives the mean over the block. Where shares differ more than matter can make them, one corner is in the
// shadow of something, and they are interpolated as they are.
vec3 blockShare(Sweep sweep, vec2 middle) {
    const float kMostContrast = 4.0;
    vec3 least = min(min(sweep.share[0], sweep.share[1]), min(sweep.share[2], sweep.share[3]));
    vec3 most = max(max(sweep.share[0], sweep.share[1]), max(sweep.share[2], sweep.share[3]));
    vec3 logarithms[4];
    for (int i = 0; i < 4; ++i) {
        logarithms[i] = log(max(sweep.share[i], vec3(1.0e-30)));
    }
    vec3 arithmetic = bilinear(sweep.share, middle);
    vec3 geometric = exp(bilinear(logarithms, middle));
    return mix(arithmetic, (2.0 * geometric + arithmetic) / 3.0, lessThan(most, kMostContrast * least));
}

Part blockPart(Sweep sweep, vec3 power, ivec3 counts, int i) {
    vec3 extent = 1.0 / vec3(counts);
    vec3 low = extent * vec3(ivec3(i % counts.x, (i / counts.x) % counts.y, i / (counts.x * counts.y)));
    vec2 middle = low.xy + 0.5 * extent.xy;
    Part part;
    part.block = blockOf(sweep, low, extent);
    part.power = power * (extent.x * extent.y) * blockShare(sweep, middle);
    part.travel = meanDirection(bilinear(sweep.after, middle) - bilinear(sweep.before, middle),
                                bilinear(sweep.lengths, middle));
    return part;
}

void depositPart(Part part) {
    Block block = part.block;
    vec3 scaled = part.power * (settings.depositScale * opaqueCompensation(block));
    vec3 flux = fluxOf(scaled, part.travel);
    for (int node = 0; node < kNodes * kNodes * kNodes; ++node) {
        ivec3 voxel = voxelOf(block, node);
        float weight = hatSum(block, offsetOf(node)) * freeShare(voxel);
        if (weight > 0.0) {
            addAt(voxel, scaled * weight, flux * weight);
        }
    }
}

void depositSweep(Sweep sweep, vec3 power, float sideU, float sideV) {
    ivec3 counts = ivec3(blocksFor(sideU / domain.voxel), blocksFor(sideV / domain.voxel),
                         blocksFor(longestStepVoxels(sweep)));
    for (int i = 0; i < counts.x * counts.y * counts.z; ++i) {
        depositPart(blockPart(sweep, power, counts, i));
    }
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= queue.liveCount) {
        return;
    }
    uint slot = liveSlot(index);
    Sweep sweep = sweepOf(slot);
    float sideU = sideAlongU(sweep);
    float sideV = sideAlongV(sweep);
    if (max(sideU, sideV) > kTooLong * settings.maxSide) {
        listForCorners(slot);
        return;
    }
    depositSweep(sweep, patches[slot].power, sideU, sideV);
}
