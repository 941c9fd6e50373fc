// Objects with lattices of their own over the domain's grids, in the scene's order: what compose_matter.cpp does voxel by
// voxel is done here at a position, with values interpolated on each object's lattice.
#include "physics/composition.glsl"
#include "shared/depth_range.h"
#include "shared/inset_blocks.h"

layout(binding = kUnitInsetValues) uniform sampler3D insetValues;
layout(binding = kUnitInsetExtents) uniform sampler3D insetExtents;
layout(binding = kUnitInsetRows) uniform usamplerBuffer insetRows;
layout(binding = kUnitInsetBricks) uniform usamplerBuffer insetBricks;

uvec4 rowOf(int inset, int row) {
    return texelFetch(insetRows, kRowsPerInset * inset + row);
}

uvec2 insetBrickAt(vec3 x) {
    ivec3 count = (domain.size + kBrickVoxels - 1) / kBrickVoxels;
    ivec3 brick = ivec3(floor((x - domain.min) / (float(kBrickVoxels) * domain.voxel)));
    brick = clamp(brick, ivec3(0), count - 1);
    int index = (brick.z * count.y + brick.y) * count.x + brick.x;
    uvec4 row = texelFetch(insetBricks, index / kInsetBricksPerRow);
    return index % kInsetBricksPerRow == 0 ? row.xy : row.zw;
}

// A bit for each inset that may be about x.
uint insetsAbout(vec3 x) {
    return insetBrickAt(x).x;
}

// Edge of the finest voxel about x over that of the domain's.
float finestVoxelAbout(vec3 x) {
    return uintBitsToFloat(insetBrickAt(x).y);
}

struct Inset {
    int number;
    vec4 placeFromDevice[3];  // rows of the map to its lattice
    ivec3 size;               // voxels
    bool displaces;           // whether it has matter of its own
};

Inset insetOf(int number) {
    Inset inset;
    inset.number = number;
    for (int axis = 0; axis < 3; ++axis) {
        inset.placeFromDevice[axis] = uintBitsToFloat(rowOf(number, kInsetPlaceRow + axis));
    }
    ivec4 size = ivec4(rowOf(number, kInsetSizeRow));
    inset.size = size.xyz;
    inset.displaces = size.w != 0;
    return inset;
}

// Place in an inset's lattice [its voxels from its lower corner].
vec3 placeIn(Inset inset, vec3 x) {
    vec4 at = vec4(x, 1.0);
    return vec3(dot(inset.placeFromDevice[0], at), dot(inset.placeFromDevice[1], at), dot(inset.placeFromDevice[2], at));
}

bool liesWithin(Inset inset, vec3 place) {
    return all(greaterThanEqual(place, vec3(0.0))) && all(lessThanEqual(place, vec3(inset.size)));
}

// Whether matter at a place in its lattice may be an inset's own.
bool displaces(Inset inset, vec3 place) {
    return inset.displaces && liesWithin(inset, place);
}

// Between the outermost voxels' centres nothing of an atlas's neighbours is seen.
vec3 betweenCentres(Inset inset, vec3 place) {
    return clamp(place, vec3(0.5), vec3(inset.size) - 0.5);
}

// Where a quantity of an inset lies in the atlas of values.
struct InsetBox {
    vec3 first;
    bool varies;  // else it has no place there
};

InsetBox boxOf(Inset inset, int quantity) {
    uvec4 row = rowOf(inset.number, kFirstInsetBoxRow + quantity);
    return InsetBox(vec3(row.xyz), row.w != 0u);
}

vec4 sampleBox(Inset inset, InsetBox box, vec3 place) {
    return sampleTrilinear(insetValues, (box.first + betweenCentres(inset, place)) * insetValueScale);
}

// Of a quantity that does not vary.
vec4 everywhereOf(Inset inset, int quantity) {
    return uintBitsToFloat(rowOf(inset.number, kFirstInsetValueRow + quantity));
}

// What the object holds of a quantity that goes with its coverage, times that.
vec4 sampleOwn(Inset inset, int quantity, vec3 place, vec4 coverage) {
    InsetBox box = boxOf(inset, quantity);
    return box.varies ? sampleBox(inset, box, place) : coverage * everywhereOf(inset, quantity);
}

ivec3 extentFirstOf(Inset inset) {
    return ivec3(rowOf(inset.number, kInsetExtentRow).xyz);
}

// The area coverage; of an opaque inset its depth, as a share of the range that depths have.
float sampleExtent(Inset inset, vec3 place) {
    return sampleTrilinear(insetExtents, (vec3(extentFirstOf(inset)) + betweenCentres(inset, place)) * insetExtentScale).r;
}

// The voxel that a place lies in.
ivec3 voxelOf(Inset inset, vec3 place) {
    return clamp(ivec3(floor(place)), ivec3(0), inset.size - 1);
}

bool isInBand(Inset inset, vec3 place) {
    return texelFetch(insetExtents, extentFirstOf(inset) + voxelOf(inset, place), 0).g > 0.5;
}

// Gradients by the inset's voxels in rgb, turned to the domain's axes [1 / scene unit].
vec4 turned(Inset inset, vec4 value) {
    vec3 gradient = value.r * inset.placeFromDevice[0].xyz + value.g * inset.placeFromDevice[1].xyz +
                    value.b * inset.placeFromDevice[2].xyz;
    return vec4(gradient, value.a);
}

// Gradient and value of the domain's index, or of its Cauchy's B, and what insets put over it.
vec4 overDomain(vec3 x, vec4 below, int quantity) {
    for (uint left = insetsAbout(x); left != 0u; left &= left - 1u) {
        Inset inset = insetOf(findLSB(left));
        vec3 place = placeIn(inset, x);
        InsetBox covered = boxOf(inset, kInsetCoverage);
        if (covered.varies && liesWithin(inset, place)) {
            vec4 coverage = sampleBox(inset, covered, place);
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
        Inset inset = insetOf(findLSB(left));
        vec3 place = placeIn(inset, x);
        InsetBox covered = boxOf(inset, kInsetCoverage);
        if (covered.varies && liesWithin(inset, place)) {
            if (isInBand(inset, place)) {
                below = true;
            } else if (below) {
                below = sampleBox(inset, covered, place).a < kBuried;
            }
        }
    }
    return below;
}

// Factor on what a boundary reflects in rgb, roughness in alpha.
vec4 surfaceOverDomain(vec3 x, vec4 below) {
    for (uint left = insetsAbout(x); left != 0u; left &= left - 1u) {
        Inset inset = insetOf(findLSB(left));
        vec3 place = placeIn(inset, x);
        if (boxOf(inset, kInsetCoverage).varies && liesWithin(inset, place) && isInBand(inset, place)) {
            below = everywhereOf(inset, kInsetSurface);
        }
    }
    return below;
}

// Absorption or emission, by area coverage.
vec3 matterOverDomain(vec3 x, vec3 below, int quantity) {
    for (uint left = insetsAbout(x); left != 0u; left &= left - 1u) {
        Inset inset = insetOf(findLSB(left));
        vec3 place = placeIn(inset, x);
        if (displaces(inset, place)) {
            float area = sampleExtent(inset, place);
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
        Inset inset = insetOf(findLSB(left));
        vec3 place = placeIn(inset, x);
        if (displaces(inset, place)) {
            float area = sampleExtent(inset, place);
            vec4 own = sampleOwn(inset, kInsetScattering, place, vec4(vec3(area), 1.0));
            vec3 kept = (1.0 - area) * below.rgb;
            float sum = meanOf(kept) + meanOf(own.rgb);
            float g = sum > 0.0 ? (meanOf(kept) * below.a + meanOf(own.rgb) * own.a) / sum : below.a;
            below = vec4(kept + own.rgb, g);
        }
    }
    return below;
}

#ifdef ANISOTROPY_BY_BAND
// The same by band, each with its own scattering as weight.
vec3 anisotropyOverDomain(vec3 x, vec3 below, vec3 scattering) {
    for (uint left = insetsAbout(x); left != 0u; left &= left - 1u) {
        Inset inset = insetOf(findLSB(left));
        vec3 place = placeIn(inset, x);
        if (displaces(inset, place)) {
            float area = sampleExtent(inset, place);
            vec4 own = sampleOwn(inset, kInsetScattering, place, vec4(vec3(area), 1.0));
            bool differs = everywhereOf(inset, kInsetAnisotropy).a > 0.0;
            vec3 g = differs ? sampleOwn(inset, kInsetAnisotropy, place, vec4(1.0)).rgb : vec3(own.a);
            vec3 kept = (1.0 - area) * scattering;
            scattering = kept + own.rgb;
            vec3 mixed = (kept * below + own.rgb * g) / max(scattering, vec3(1.0e-30));
            below = mix(below, mixed, greaterThan(scattering, vec3(0.0)));
        }
    }
    return below;
}
#endif

// Albedo in rgb, depth in opaque matter in alpha, of what the object has in its extent.
vec4 sampleOwnOpaque(Inset inset, vec3 place, float extent) {
    InsetBox box = boxOf(inset, kInsetOpaque);
    vec4 plain = vec4(everywhereOf(inset, kInsetOpaque).rgb, inset.displaces ? kLeastDepth : extent);
    return box.varies ? sampleBox(inset, box, place) : plain;
}

// Albedo in rgb, depth in opaque matter in alpha, which transparent matter takes away. How two bodies' surfaces lie to each
// other is not known at a place: as if across.
vec4 opaqueOverDomain(vec3 x, vec4 below) {
    const float kAcross = 0.0;
    for (uint left = insetsAbout(x); left != 0u; left &= left - 1u) {
        Inset inset = insetOf(findLSB(left));
        vec3 place = placeIn(inset, x);
        if (liesWithin(inset, place)) {
            float extent = sampleExtent(inset, place);
            extent = inset.displaces ? extent : mix(kLeastDepth, kMostDepth, extent);
            vec4 own = sampleOwnOpaque(inset, place, extent);
            float area = shareOfDepth(extent);
            float added = shareOfDepth(own.a);
            float sum = (1.0 - area) * shareOfDepth(below.a) + added;
            float transparent = area - added;
            float kept = transparent > 0.0 ? min(below.a, 1.0 - transparent) : below.a;
            below = vec4(sum > 0.0 ? mix(below.rgb, own.rgb, added / sum) : below.rgb, joinedDepth(kept, own.a, kAcross));
        }
    }
    return below;
}
