// Structs, binding points and sizes of the bake by ray tubes, read by GLSL (std430 / std140) and by C++.
// Lengths in scene units, optical path t in scene units.

#include "shaders/shared/bake_blocks.h"

#ifdef __cplusplus
#pragma once
namespace eikonal::bake {
using glm::uvec2;
using glm::uvec4;
using glm::vec4;
#endif

// A window is a stretch of optical path of TUBE_STEPS steps; a vertex's track through it has a sample at both ends of each.
// Sample k is bit k of a mask of two words.
#define TUBE_SAMPLES 64
#define TUBE_STEPS 63

#define TUBE_VERTICES_BINDING 0
#define TUBE_POSITIONS_BINDING 1
#define TUBE_SHARES_BINDING 2
#define TUBE_FRAMES_BINDING 3
#define TUBE_ITEMS_BINDING 4     // what a kernel works on, one an invocation
#define TUBE_RESULTS_BINDING 5   // what it answers
#define TUBE_NODES_BINDING 6
#define TUBE_REFLECTIONS_BINDING 7   // trace, where reflections are followed
#define TUBE_PARTS_BINDING 1     // deposit: lists of the parts of cells; the sums lie at 2 to 7
#define TUBE_FREE_SAMPLES_BINDING 0  // the same: samples in front of the opaque matter that cuts a voxel
#define TUBE_EIKONAL_BINDING 2   // deposit of the eikonal, in place of the sums
#define TUBE_SORT_RECORDS_BINDING 5  // sort: cells and the lists of their parts, beside the tracks
#define TUBE_SORT_PARTS_BINDING 7
#define TUBE_SETTINGS_BINDING 2  // uniform block

#define TUBE_NOT_LAUNCHED 0xFFFFFFFFu

// A vertex of the launch mesh: an exact ray.
struct TubeVertex {
    Particle ray;
    vec2 launch;
    uint frameIndex;
    uint stepCount;  // steps since launch, or TUBE_NOT_LAUNCHED
};

// A vertex that is new.
struct TubePlacement {
    vec2 launch;
    uint frameIndex;
    uint vertex;
};

// What a vertex's track did in the window.
struct TubePresence {
    uvec2 near;       // steps that begin or end near the domain
    uvec2 bent;       // steps that are not straight, or along which the share changes
    uint ended;       // 1: nothing of it will be near the domain any more
    float remaining;  // largest share of its power that is not yet past the domain at the end of the window
    uint unusedA;
    uint unusedB;
};

// What a ray has lost by reflection at boundaries since its launch, or since its last mirror, crossing by crossing.
#define TUBE_CROSSINGS 15
struct TubeReflections {
    float shares[TUBE_CROSSINGS];  // of the launched power, strongest band
    uint crossings;
};

// The mirrors of a path in one word: of each, first to last from the lowest bits, which crossing after the one before it is
// a reflection, less one.
#define TUBE_MIRROR_BITS 4u
#define TUBE_MAX_MIRRORS 8

// An edge of the mesh with the ray in its middle.
struct TubeEdge {
    uint middle;
    uint first;
    uint second;
    uint unused;
};

// A rectangle of launch coordinates with 3 x 3 vertices, row by row: four sub-cells.
struct TubeNode {
    uint vertices[9];
    uint frameIndex;
    uint unusedA;
    uint unusedB;
    vec4 launchShare;  // power launched into each sub-cell, over the frame's strength
};

// Samples at which the middle of an edge or a node is not where its neighbours say it is.
struct TubeMeasure {
    uvec2 strong;      // with enough power to be refined
    uvec2 weak;        // with less
    vec4 launchShare;  // of a node
};

// A vertex that takes the mean of two others at the samples where it is not live.
struct TubeConformity {
    uint vertex;
    uint first;
    uint second;
    uint unusedA;
    uvec2 live;
    uvec2 unusedB;
};

// A node over some steps of the window that are deposited as one: more than one only where its rays are straight.
struct TubeJob {
    uint node;
    uint steps;  // packed: sample at which they begin, how many, and whether the node is not resolved, for want of power
};
#define TUBE_JOB_COUNT_BIT 8u
#define TUBE_JOB_WEAK_BIT 16u
#define TUBE_MAX_JOB_STEPS 3

// In place of the root of a volume: the cell's own map tells it better.
#define TUBE_OWN_VOLUME -1.0

// A sub-cell over some steps, what the wavefront patch sweeps, takes at most so many rows of four words (cell_rows.glsl).
#define TUBE_MOST_CELL_ROWS 22

// Lists of the parts of cells that are deposited alike; they follow in the block, the first entries of all before the second.
#define TUBE_GATHER_LIST 0
#define TUBE_LINE_LIST 1
#define TUBE_RAY_LIST 2
#define TUBE_DEPOSIT_LISTS 3
#define TUBE_EVEN_LIST 3      // cells, by their first part: volumes and parts are still to come
#define TUBE_UNEVEN_LIST 4    // parts that are still to be sorted
#define TUBE_CUT_LIST 5       // gathered parts that reach into voxels which opaque matter cuts; last, for without it there is none
#define TUBE_LISTS 6

// Samples along each axis of a voxel that opaque matter cuts.
#define TUBE_SAMPLES_ACROSS_CUT 4

// What has been listed, and the indirect dispatch with its invocations: one a part, or GATHERS_PER_PART that gather it.
struct TubePartList {
    uvec3 groups;
    uint count;
};

// What the lists begin with.
struct TubePartsHeader {
    TubePartList lists[TUBE_LISTS];
    uint foldedCells;  // in which the wavefront turned inside out, since the bake began
    uint unusedA;
    uint unusedB;
    uint unusedC;
};

// A part of a cell: its number, the binary logarithms of the cuts along u, v and t, and which of them it is.
#define TUBE_PART_CELL_BITS 16u
#define TUBE_MAX_JOBS 16384u        // a chunk: four cells each
#define TUBE_MOST_LOG_CUTS 6        // of a cell
#define TUBE_MAX_PARTS 64u          // of a cell: 2 to the power of that

// Uniform block.
struct TubeSettings {
    uint firstStep;        // of the window
    uint itemCount;        // invocations that have something to do
    float maxDeviation;    // of a middle from its neighbours' mean [scene units]
    float maxShareDeviation;  // the same of shares, relative
    float resolvedSide;    // shares are resolved to edges of this length [scene units]
    float maxUnevenness;   // change of irradiance between two samples that a gather may have, in logarithm
    uint samplesPerVoxel;  // along each axis
    float nearMargin;      // how far from the domain counts as near [scene units]
    float maxUnevenSpread; // of a middle from its neighbours' mean along the line between them, over their distance
    float evenSide;        // shorter edges may be uneven [scene units]
    uint mirrorCount;      // of the path that is followed
    uint mirrors;          // TUBE_MIRROR_BITS each
};

#ifdef __cplusplus
static_assert(sizeof(TubeVertex) == 208 && sizeof(TubePlacement) == 16);
static_assert(sizeof(TubePresence) == 32 && sizeof(TubeEdge) == 16);
static_assert(sizeof(TubeReflections) == 64 && TUBE_CROSSINGS <= 1u << TUBE_MIRROR_BITS);
static_assert(TUBE_MAX_MIRRORS * TUBE_MIRROR_BITS <= 32);
static_assert(sizeof(TubeNode) == 64 && offsetof(TubeNode, launchShare) == 48);
static_assert(sizeof(TubeMeasure) == 32 && sizeof(TubeConformity) == 32 && sizeof(TubeJob) == 8);
static_assert(sizeof(TubePartList) == 16 && sizeof(TubePartsHeader) == 112 && sizeof(TubeSettings) == 48);
} // namespace eikonal::bake
#endif
