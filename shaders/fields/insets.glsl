// Objects with lattices of their own over the domain's grids, in the scene's order: what compose_matter.cpp does voxel by
// voxel is done here at a position, with values interpolated on each object's lattice.
#include "physics/composition.glsl"
#include "shared/inset_blocks.h"

layout(binding = kUnitInsetValues) uniform sampler3D insetValues;
layout(binding = kUnitInsetExtents) uniform sampler3D insetExtents;
layout(std430, binding = kStorageInsetBricks) readonly buffer InsetBricks { uvec2 insetBricks[]; };

uvec2 insetBrickAt(vec3 x) {
    ivec3 count = (domain.size + kBrickVoxels - 1) / kBrickVoxels;
    ivec3 brick = ivec3(floor((x - domain.min) / (float(kBrickVoxels) * domain.voxel)));
    brick = clamp(brick, ivec3(0), count - 1);
    return insetBricks[(brick.z * count.y + brick.y) * count.x + brick.x];
}

// A bit for each inset that may be about x.
uint insetsAbout(vec3 x) {
    return insetBrickAt(x).x;
}

// Edge of the finest voxel about x over that of the domain's.
float finestVoxelAbout(vec3 x) {
    return uintBitsToFloat(insetBrickAt(x).y);
}

// Place in an inset's lattice [its voxels from its lower corner].
vec3 placeIn(int inset, vec3 x) {
    vec4 at = vec4(x, 1.0);
    return vec3(dot(insets[inset].placeFromDevice[0], at), dot(insets[inset].placeFromDevice[1], at),
                dot(insets[inset].placeFromDevice[2], at));
}

bool liesWithin(int inset, vec3 place) {
    return all(greaterThanEqual(place, vec3(0.0))) && all(lessThanEqual(place, vec3(insets[inset].size)));
}

// Whether matter at a place in its lattice may be an inset's own.
bool displaces(int inset, vec3 place) {
    return insets[inset].displaces != 0 && liesWithin(inset, place);
}

// Between the outermost voxels' centres nothing of an atlas's neighbours is seen.
vec3 betweenCentres(int inset, vec3 place) {
    return clamp(place, vec3(0.5), vec3(insets[inset].size) - 0.5);
}

bool varies(int inset, int quantity) {
    return insets[inset].first[quantity].w != 0;
}

// Of a quantity that varies.
vec4 sampleValue(int inset, int quantity, vec3 place) {
    vec3 texel = vec3(insets[inset].first[quantity].xyz) + betweenCentres(inset, place);
    return sampleTrilinear(insetValues, texel * insetValueScale);
}

// What the object holds of a quantity that goes with its coverage, times that.
vec4 sampleOwn(int inset, int quantity, vec3 place, vec4 coverage) {
    return varies(inset, quantity) ? sampleValue(inset, quantity, place) : coverage * insets[inset].everywhere[quantity];
}

float sampleArea(int inset, vec3 place) {
    vec3 texel = vec3(insets[inset].extentFirst) + betweenCentres(inset, place);
    return sampleTrilinear(insetExtents, texel * insetExtentScale).r;
}

// The voxel that a place lies in.
ivec3 voxelOf(int inset, vec3 place) {
    return clamp(ivec3(floor(place)), ivec3(0), insets[inset].size - 1);
}

bool isInBand(int inset, vec3 place) {
    return texelFetch(insetExtents, insets[inset].extentFirst + voxelOf(inset, place), 0).g > 0.5;
}

// Gradients by the inset's voxels in rgb, turned to the domain's axes [1 / scene unit].
vec4 turned(int inset, vec4 value) {
    vec3 gradient = value.r * insets[inset].placeFromDevice[0].xyz + value.g * insets[inset].placeFromDevice[1].xyz +
                    value.b * insets[inset].placeFromDevice[2].xyz;
    return vec4(gradient, value.a);
}

// Gradient and value of the domain's index, or of its Cauchy's B, and what insets put over it.
vec4 overDomain(vec3 x, vec4 below, int quantity) {
    for (uint left = insetsAbout(x); left != 0u; left &= left - 1u) {
        int inset = findLSB(left);
        vec3 place = placeIn(inset, x);
        if (varies(inset, kInsetCoverage) && liesWithin(inset, place)) {
            vec4 coverage = sampleValue(inset, kInsetCoverage, place);
            vec4 own = sampleOwn(inset, quantity, place, coverage);
            below = composedOver(below, turned(inset, coverage), turned(inset, own));
        }
    }
    return below;
}

// Whether x is in the band of a boundary, given whether it is in one of the domain's. An object buries those under it.
bool bandOverDomain(vec3 x, bool below) {
    const float kBuried = 0.997;
    for (uint left = insetsAbout(x); left != 0u; left &= left - 1u) {
        int inset = findLSB(left);
        vec3 place = placeIn(inset, x);
        if (varies(inset, kInsetCoverage) && liesWithin(inset, place)) {
            if (isInBand(inset, place)) {
                below = true;
            } else if (below) {
                below = sampleValue(inset, kInsetCoverage, place).a < kBuried;
            }
        }
    }
    return below;
}

// Factor on what a boundary reflects in rgb, roughness in alpha.
vec4 surfaceOverDomain(vec3 x, vec4 below) {
    for (uint left = insetsAbout(x); left != 0u; left &= left - 1u) {
        int inset = findLSB(left);
        vec3 place = placeIn(inset, x);
        if (varies(inset, kInsetCoverage) && liesWithin(inset, place) && isInBand(inset, place)) {
            below = insets[inset].everywhere[kInsetSurface];
        }
    }
    return below;
}

// Absorption or emission, by area coverage.
vec3 matterOverDomain(vec3 x, vec3 below, int quantity) {
    for (uint left = insetsAbout(x); left != 0u; left &= left - 1u) {
        int inset = findLSB(left);
        vec3 place = placeIn(inset, x);
        if (displaces(inset, place)) {
            float area = sampleArea(inset, place);
            below = (1.0 - area) * below + sampleOwn(inset, quantity, place, vec4(area)).rgb;
        }
    }
    return below;
}

float meanOf(vec3 bands) {
    return (bands.r + bands.g + bands.b) / 3.0;
}

// Scattering in rgb, g in alpha: averaged with the scattering that it belongs to as weight.
vec4 scatteringOverDomain(vec3 x, vec4 below) {
    for (uint left = insetsAbout(x); left != 0u; left &= left - 1u) {
        int inset = findLSB(left);
        vec3 place = placeIn(inset, x);
        if (displaces(inset, place)) {
            float area = sampleArea(inset, place);
            vec4 own = sampleOwn(inset, kInsetScattering, place, vec4(vec3(area), 1.0));
            vec3 kept = (1.0 - area) * below.rgb;
            float sum = meanOf(kept) + meanOf(own.rgb);
            float g = sum > 0.0 ? (meanOf(kept) * below.a + meanOf(own.rgb) * own.a) / sum : below.a;
            below = vec4(kept + own.rgb, g);
        }
    }
    return below;
}

// Albedo in rgb, coverage by opaque matter in alpha, which transparent matter takes away.
vec4 opaqueOverDomain(vec3 x, vec4 below) {
    for (uint left = insetsAbout(x); left != 0u; left &= left - 1u) {
        int inset = findLSB(left);
        vec3 place = placeIn(inset, x);
        if (liesWithin(inset, place)) {
            float area = sampleArea(inset, place);
            vec4 own = sampleOwn(inset, kInsetOpaque, place, vec4(1.0, 1.0, 1.0, area));
            float sum = (1.0 - area) * below.a + own.a;
            below = vec4(sum > 0.0 ? mix(below.rgb, own.rgb, own.a / sum) : below.rgb, sum);
        }
    }
    return below;
}
