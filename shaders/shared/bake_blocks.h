// Structs, binding points and workgroup sizes of the bake, read by GLSL (std430 / std140) and by C++.
// Lengths in scene units, optical path t in scene units, powers per band.

#ifdef __cplusplus
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
namespace eikonal::bake {
using uint = std::uint32_t;
using glm::uvec3;
using glm::vec2;
using glm::vec3;
#endif

#define BAKE_GROUP_SIZE 64

#define BAKE_PATCHES_BINDING 0
#define BAKE_QUEUE_BINDING 1
#define BAKE_FRAMES_BINDING 2   // emit, refine and split
#define BAKE_RECORDS_BINDING 3  // emit and refine
#define BAKE_LEDGER_BINDING 4   // retire
#define BAKE_FLUX_BINDING 2        // deposit: flux along x, y, z at 2, 3, 4
#define BAKE_IRRADIANCE_BINDING 5  // deposit: bands at 5, 6, 7
#define BAKE_LOBE_ROWS_BINDING 2       // deposit with LIGHT_LOBES, in place of the sums
#define BAKE_LOBE_SCALES_BINDING 3     // likewise
#define BAKE_LOBE_POWERS_BINDING 4     // likewise
#define BAKE_LOBE_FLUXES_BINDING 5     // likewise
#define BAKE_PEAK_SUM_BINDING 2        // deposit_peak; its bands at BAKE_IRRADIANCE_BINDING
#define BAKE_PEAK_DIRECTION_BINDING 3  // deposit_peak
#define BAKE_SETTINGS_BINDING 1    // uniform block
#define BAKE_PEAK_PASS_BINDING 2   // uniform block

// What a corner particle is doing.
#define PARTICLE_WAITING 0u  // on its straight way to the domain
#define PARTICLE_MIRRORED 1u  // on the straight way that its image in a mirror has come, w: velocity per optical path
#define PARTICLE_INSIDE 2u
#define PARTICLE_EXITED 3u   // left the domain
#define PARTICLE_BLOCKED 4u  // hit opaque matter
#define PARTICLE_MISSED 5u   // never meets the domain, or not the mirrors that it is followed from

// Angular profiles of launch frames (physics/profile.glsl).
#define PROFILE_NONE 0u
#define PROFILE_CONE 1u
#define PROFILE_COSINE 2u

// Rows of the energy ledger; each holds three bands.
#define LEDGER_ENTERED 0
#define LEDGER_ABSORBED 1
#define LEDGER_OPAQUE 2
#define LEDGER_SCATTERED 3
#define LEDGER_EXITED 4
#define LEDGER_REFLECTED 5
#define LEDGER_CULLED 6
#define LEDGER_TINTED 7    // taken up by boundaries that reflect less than Fresnel's share
#define LEDGER_FOLLOWED 8  // of what was reflected, power that rays of its own follow
#define LEDGER_ROWS 9

// A direction in one word: three components of ten bits, -1 to 1 in twice this many steps. 0: none.
#define PEAK_DIRECTION_STEPS 511

// Bins of direction that a voxel's light is sorted into: an octahedral map of the sphere of so many squares each way.
#define LOBE_BINS_ACROSS 8
#define LOBE_BINS (LOBE_BINS_ACROSS * LOBE_BINS_ACROSS)

// Passes of deposit_peak.
#define PEAK_RAISE 0u   // irradiances are raised to the largest
#define PEAK_DIRECT 1u  // whoever holds the largest leaves its direction

// A launch surface: the ray of launch coordinates (u, v) in [-1, 1]^2 passes through centre + a u + b v.
struct LaunchFrame {
    vec3 origin;       // point light: its position; parallel beam: unit direction of travel
    uint isPoint;
    vec3 centre;
    float phase;       // optical path at the foot of the axis, so that t = 0 before anything meets the domain
    vec3 a;
    uint cellsU;       // cells of the launch grid along u
    vec3 b;
    uint cellsV;
    vec3 strength;     // point: power per steradian where its profile is 1; beam: power per unit area
    float splitPower;  // patches with less remaining power are not split
    vec3 axis;         // point: centre - origin
    uint firstCell;    // number of the frame's first cell among all frames'
    vec3 profileAxis;  // unit
    uint profile;      // PROFILE_...
    float coneInner;   // versine of the angle to the axis up to which the profile of a cone is 1
    float coneOuter;   // versine of the angle from which it is 0
    float pathBefore;  // optical path from the light to where t = 0 [scene units]
    float unusedA;
};

// A corner of a patch: an exact ray from its launch coordinate. Shares are fractions of the frame's strength: of the power
// that would be launched along it if its profile were 1.
struct Particle {
    vec3 x;
    float enterPath;      // optical path at which it enters the domain, or leaves its last mirror
    vec3 w;               // wave vector
    uint status;
    vec3 xPrevious;       // before the last step
    float throughputS;    // product of Fresnel transmittances, s polarisation
    vec3 transmittance;   // of the medium so far
    float throughputP;
    vec3 meanShare;       // mean of transmittance x throughput over the last step
    float enteredShare;   // launchShare once it has entered
    vec3 normal;          // Crossing
    float gradMax;
    float nStart;
    float nLast;
    float along;
    float sideAtStart;
    vec3 absorbedShare;
    float arcLength;      // of the last step
    vec3 scatteredShare;
    float launchShare;    // the profile along it, 0 to 1
    vec3 reflectedShare;
    float litPart;        // of the last step: what lies in front of opaque matter
    vec3 tint;            // of the boundary that is being crossed, where it is steepest so far
    float weight;         // Crossing
    vec3 tintedShare;     // what tints have taken from what boundaries reflect
    float blockedAt;      // steps since launch at which it met opaque matter; 0: it has not
};

// A piece of a wavefront: corners in the order (u0, v0), (u1, v0), (u1, v1), (u0, v1) of its launch rectangle.
struct WavefrontPatch {
    Particle corners[4];
    vec2 launchMin;
    vec2 launchMax;
    vec3 power;           // launched into the rectangle if the profile is 1 all over it
    uint frameIndex;
    uint stepCount;       // steps since launch: t = stepCount * opticalStep
    uint orientation;     // 0 unknown, 1 along, 2 against the direction of travel
    uint unusedA;
    uint unusedB;
};

// A patch that waits for a place: traced anew from the source up to stepCount.
struct LaunchRecord {
    vec2 launchMin;
    vec2 launchMax;
    uint frameIndex;
    uint stepCount;
    uint orientation;
    uint unusedA;
};

// Index lists of the pool, of capacity entries each, that follow QueueState in its block; 0 and 1 hold the live patches
// of even and odd rounds.
#define FREE_RING 2u    // slots free to take, between freeHead and freeTail
#define RETIRE_LIST 3u
#define SPLIT_LIST 4u         // slot, and a bit for the side to split
#define SPLIT_TARGET_LIST 5u  // slot of its second half
#define CORNERS_LIST 6u       // patches whose corners deposit on their own
#define POOL_LISTS 7u
#define SPLIT_ALONG_U 0x80000000u

// Counters of the pool.
struct QueueState {
    uvec3 particleGroups;   // indirect dispatch: a particle an invocation
    uint liveCount;
    uvec3 patchGroups;      // indirect dispatch: a patch an invocation
    uint nextLiveCount;
    uvec3 emitGroups;       // indirect dispatch: a corner of a new patch an invocation
    uint emitCount;
    uvec3 cornersGroups;    // indirect dispatch: a corner of a listed patch an invocation
    uint cornersCount;
    uvec3 retireGroups;     // indirect dispatch: a listed patch an invocation
    uint retireCount;
    uvec3 splitGroups;      // indirect dispatch: a new corner of a listed patch an invocation
    uint splitCount;
    uint recordCount;       // launch records waiting
    uint recordTake;        // of them, taken by this round's emit
    uint nextCell;          // first cell of the launch grids not yet emitted
    uint parity;            // which live list is current
    uint freeHead;          // ring: next slot to take
    uint freeTail;          // ring: next place to return a slot to
    uint freeTailAtStart;   // slots returned in this round cannot be taken in it
    uint recordOverflow;    // splits refused because the records were full
    uint stepsLow;          // patch-steps, two words
    uint stepsHigh;
    uint evaluationsLow;    // field evaluations, two words
    uint evaluationsHigh;
    uint splits;
    uint folds;
    uint peakLive;
    uint unusedA;
};

// Uniform block.
struct BakeSettings {
    float opticalStep;       // [scene units]
    float maxSide;           // longest side of a patch [scene units]
    float cullShare;         // patches whose mean remaining share is below are culled
    uint maxSteps;
    float depositScale;      // fixed-point units per power x length in voxels
    float ledgerScale;       // fixed-point units per power
    uint cellCount;          // of all launch grids
    uint capacity;           // patches in the pool
    uint recordCapacity;
    int slabBegin;           // this pass deposits into voxel layers slabBegin <= k < slabEnd
    int slabEnd;
    uint foldsEnd;           // 1: patches that turn inside out are culled
};

// Uniform block.
struct PeakPass {
    uint pass;
    uint unusedA;
    uint unusedB;
    uint unusedC;
};

#ifdef __cplusplus
static_assert(sizeof(LaunchFrame) == 128 && offsetof(LaunchFrame, strength) == 64);
static_assert(offsetof(LaunchFrame, profileAxis) == 96);
static_assert(sizeof(Particle) == 192 && offsetof(Particle, nStart) == 96);
static_assert(sizeof(WavefrontPatch) == 816 && offsetof(WavefrontPatch, power) == 784);
static_assert(sizeof(LaunchRecord) == 32);
static_assert(sizeof(QueueState) == 160 && offsetof(QueueState, recordCount) == 96);
static_assert(sizeof(BakeSettings) == 48);
static_assert(sizeof(PeakPass) == 16);
} // namespace eikonal::bake
#endif
