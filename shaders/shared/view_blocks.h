#pragma once
// What the stages of the viewer hand to each other.

#include "shaders/shared/bindings.h"

#ifdef __cplusplus
#include <cstddef>

#include <glm/glm.hpp>

namespace eikonal::gpu {

using glm::ivec2;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = unsigned int;
#endif

const int kUniformView = 1;

const int kStorageRays = 0;      // RayState, one a ray, as rows of four words
const int kStorageFilm = 2;      // FilmPixel, one a pixel, as rows of four words
const int kStorageDisplay = 3;   // vec4, one a pixel
const int kStorageCounters = 4;  // rays that entered and field evaluations, look-ups of clearance
                                 // and samples of matter, each low word, high word
const int kStorageTakenRays = 5;   // RayListHead, then entries (viewer/ray_lists.glsl): the rays that a dispatch takes
const int kStorageFilledRays = 1;  // the same of those that it leaves to the next
const int kStorageGiven = 7;       // GivenRay, one a ray, where rays are begun; later kStorageDirectRays is there

const int kBlockEdge = 8;  // of the pixels whose rays a workgroup takes
const int kRaysPerGroup = kBlockEdge * kBlockEdge;
const int kPicturePieces = 89;  // in which a tile's blocks are listed (viewer/picture_order.glsl)
const int kRaysPerCount = 16;  // that one invocation counts

// Where a ray is in its life.
const uint kMarching = 0u;
const uint kExited = 1u;
const uint kHitOpaque = 2u;
const uint kStepLimit = 3u;
const uint kMissed = 4u;      // never entered the domain
const uint kAttenuated = 5u;  // nothing behind it can be seen
const uint kNoRay = 6u;       // a place for a reflection's ray that is free

// Set in an entry of a list, beside the ray's index: nothing happens to the ray in its next step that is known yet. Without it
// that step has been looked at, and needs care.
const uint kIsPlain = 0x80000000u;
const uint kNoEntry = 0xffffffffu;  // a place of a list without a ray, or no place at all

// In place of a band's channel: the pass at the reference wavelength.
const uint kAllChannels = 3u;

// A ray under way, what a march changes most often first (viewer/ray_rows.glsl). Radiance is basic radiance, L/n^2,
// until the shade stage makes a pixel's of it.
struct RayState {
    vec3 x;               // position [scene units]
    float pathLength;     // inside the domain [scene units]
    vec3 w;               // wave vector
    float opticalLength;  // integral of n over the path [scene units]
    float n;              // index at the last evaluation
    uint status;
    uint evaluations;     // of the index field
    uint lookUps;         // of the clearance ahead
    float lookAgainAt;    // path length at which the next look-up may find something [scene units]
    uint matterSamples;   // of absorption, scattering and emission
    uint dispersed;       // 1: it has been where the index depends on the wavelength
    uint generation;      // mirrors on its way from the camera
    vec3 depth;           // optical depth of extinction by band
    float nCamera;        // index where the ray starts
    vec3 transmittance;   // exp(-depth)
    float entryDistance;  // from the start to the domain [scene units]
    vec3 radiance;
    float throughputS;    // Fresnel transmittances so far, by polarisation
    vec3 crossingNormal;  // the boundary under way (physics/boundary.glsl); shaded: of the surface at the ray's end, or 0
    float throughputP;
    float crossingGradMax;
    float crossingStart;
    float crossingWeight; // times Crossing::sideAtStart
    float crossingAlong;
};

// What a ray adds to the statistics.
struct RayCost {
    uint entered;        // 1: it has entered the domain
    uint evaluations;
    uint lookUps;
    uint matterSamples;
};

struct RayListHead {
    uint groups[3];  // of a dispatch over the list
    uint count;
};

struct GivenRay {
    vec3 origin;
    float pad0;
    vec3 direction;  // unit
    float pad1;
};

struct FilmPixel {
    vec3 radiance;       // mean over the samples so far
    float halfLuminance; // mean over those samples that are in the first of two halves
    vec3 exitDirection;  // of the ray through the pixel's centre, like all that follows
    float entryDistance;
    vec3 depth;
    float opticalLength;
    vec3 throughput;     // of the background behind
    float steps;         // evaluations but one, and look-ups
    vec3 normal;         // of the opaque surface at the ray's end, or 0
    float normalPad;
};

struct ViewBlock {
    vec3 cameraPosition;      // [scene units]
    float stepLength;         // [scene units]
    vec3 cameraRight;         // half the image's width at distance 1
    float minThroughput;      // below it a ray ends
    vec3 cameraUp;            // half its height
    float environmentAngle;   // about +Y [radians]
    vec3 cameraForward;       // unit
    float environmentScale;   // factor on the map
    vec3 horizon;             // radiance of the gradient, intensity included
    uint rayCount;
    vec3 zenith;
    uint stepsPerSlice;
    vec3 lightMin;            // lower corner of the baked light's box [scene units]
    uint maxEvaluations;      // of the index field, look-ups of clearance included
    vec3 lightScale;          // texture coordinate per scene unit
    float opaqueOffset;       // distance off a surface at which light is looked up [scene units]
    ivec2 imageSize;          // [pixels]
    ivec2 tileOrigin;
    ivec2 tileSize;
    vec2 subPixel;            // sample position within each pixel, 0 to 1
    float exposureScale;
    uint roundIndex;          // 0: the ray through each pixel's centre
    float sampleWeight;       // of this sample in the mean of those so far
    uint filmStart;           // pixels of the film before the tile's
    vec4 ambient[6];          // cosine-weighted mean radiance about +X, -X, +Y, -Y, +Z, -Z
    vec3 contentMin;          // the box of all that is not vacuum [scene units]
    float negligibleGradient; // |grad n| that counts as none [1 / scene unit]
    vec3 contentMax;
    uint dispersedAtStart;    // RayState::dispersed of new rays
    vec3 bandToRgb;           // linear Rec.709 of a unit of radiance in the band
    uint bandChannel;         // of the ray's radiance: the one that the band is about, or kAllChannels
    uint mostGenerations;     // of reflections that are followed
    float leastReflected;     // throughput below which a reflection is seen in the environment
    vec2 lensSequence;        // place of the sample in the sequence of the lens, 0 to 1
    float lensRadius;         // [scene units]; 0: through its middle
    float focusDistance;      // of the plane in focus, along cameraForward [scene units]
    float halfWeight;         // of this sample in the mean of those in the first half so far, 0 if it is in the other
    uint lensHalf;            // the half that it is in
    float sampleShare;        // of each of the samples that the scene asks for
    uint fewRays;             // so many go on from event to event in a slice
    uint stepsPerDispatch;    // of all its rays together
    float padA;
};

#ifdef __cplusplus
static_assert(sizeof(RayState) == 144 && offsetof(RayState, crossingGradMax) == 128);
static_assert(offsetof(RayState, w) == 16 && offsetof(RayState, status) == 36 && offsetof(RayState, depth) == 64);
static_assert(sizeof(RayCost) == 16 && sizeof(RayListHead) == 16);
static_assert(sizeof(GivenRay) == 32 && sizeof(FilmPixel) == 80);
// The rows of viewer/film_pixels.glsl.
static_assert(offsetof(FilmPixel, halfLuminance) == 12 && offsetof(FilmPixel, exitDirection) == 16 && offsetof(FilmPixel, entryDistance) == 28);
static_assert(offsetof(FilmPixel, depth) == 32 && offsetof(FilmPixel, opticalLength) == 44 && offsetof(FilmPixel, throughput) == 48);
static_assert(offsetof(FilmPixel, steps) == 60 && offsetof(FilmPixel, normal) == 64);
static_assert(offsetof(ViewBlock, horizon) == 64 && offsetof(ViewBlock, imageSize) == 128);
static_assert(offsetof(ViewBlock, exposureScale) == 160 && offsetof(ViewBlock, ambient) == 176);
static_assert(offsetof(ViewBlock, contentMin) == 272 && offsetof(ViewBlock, bandToRgb) == 304);
static_assert(offsetof(ViewBlock, sampleShare) == 352 && sizeof(ViewBlock) == 368);

} // namespace eikonal::gpu
#else
layout(std140, binding = kUniformView) uniform View { ViewBlock viewGiven; };

// Read once, as the domain is, in the order of the members.
ViewBlock view = ViewBlock(
    viewGiven.cameraPosition, viewGiven.stepLength, viewGiven.cameraRight, viewGiven.minThroughput, viewGiven.cameraUp,
    viewGiven.environmentAngle, viewGiven.cameraForward, viewGiven.environmentScale, viewGiven.horizon,
    viewGiven.rayCount, viewGiven.zenith, viewGiven.stepsPerSlice, viewGiven.lightMin, viewGiven.maxEvaluations,
    viewGiven.lightScale, viewGiven.opaqueOffset, viewGiven.imageSize, viewGiven.tileOrigin, viewGiven.tileSize,
    viewGiven.subPixel, viewGiven.exposureScale, viewGiven.roundIndex, viewGiven.sampleWeight, viewGiven.filmStart,
    viewGiven.ambient, viewGiven.contentMin, viewGiven.negligibleGradient, viewGiven.contentMax,
    viewGiven.dispersedAtStart, viewGiven.bandToRgb, viewGiven.bandChannel, viewGiven.mostGenerations,
    viewGiven.leastReflected, viewGiven.lensSequence, viewGiven.lensRadius, viewGiven.focusDistance,
    viewGiven.halfWeight, viewGiven.lensHalf, viewGiven.sampleShare, viewGiven.fewRays,
    viewGiven.stepsPerDispatch, 0.0);
#endif
