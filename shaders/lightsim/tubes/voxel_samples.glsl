// The samples that a voxel's mean is taken from. Voxels that opaque matter cuts have more of them than others (CUT_VOXELS), so
// that an eighth of a voxel is seen, and those in front of it stand for all that is free: whatever that is, even light leaves an
// even irradiance.
#ifdef EFFECT_OPAQUE
#include "fields/fields.glsl"

float freeShareOf(ivec3 voxel) {
    return 1.0 - shareOfDepth(texelFetch(opaqueGrid, voxel, 0).a);
}

bool isCut(ivec3 voxel) {
    float free = freeShareOf(voxel);
    return free > 0.0 && free < 1.0;
}

// Whether there is one between two points [voxels].
bool meetsCutVoxel(vec3 low, vec3 high) {
    ivec3 first = ivec3(floor(low));
    ivec3 last = min(ivec3(floor(high)), domain.size - 1);
    bool meets = false;
    for (int k = first.z; k <= last.z && !meets; ++k) {
        for (int j = first.y; j <= last.y && !meets; ++j) {
            for (int i = first.x; i <= last.x && !meets; ++i) {
                meets = isCut(ivec3(i, j, k));
            }
        }
    }
    return meets;
}
#endif

#ifdef CUT_VOXELS
#include "lightsim/tubes/free_samples.glsl"

int samplesAcross() {
    return TUBE_SAMPLES_ACROSS_CUT;
}

bool hasSamples(ivec3 voxel) {
    return isCut(voxel);
}

// Of the voxel's light that a sample stands for; where none is in front of the matter, that of any.
float sampleShareIn(ivec3 voxel) {
    float across = float(samplesAcross());
    uint free = freeSamplesIn(voxel);
    return free > 0u ? freeShareOf(voxel) / float(free) : 1.0 / (across * across * across);
}
#else

int samplesAcross() {
    return int(tube.samplesPerVoxel);
}

bool hasSamples(ivec3 voxel) {
#ifdef EFFECT_OPAQUE
    return freeShareOf(voxel) == 1.0;
#else
    return true;
#endif
}

float sampleShareIn(ivec3 voxel) {
    float across = float(samplesAcross());
    return 1.0 / (across * across * across);
}
#endif

// Where samples of number 0 lie [spacings of samples]. In the middle but for less than a hundredth: the faces of cells of a beam lie
// at simple fractions of a voxel along simple directions, and what lies on a face may fall to both sides or to neither. Of
// directions of ones and noughts none has samples less than 1.3e-4 of a voxel from such a place; rays round off about as much.
const vec3 kFirstSample = vec3(0.5018, 0.5073, 0.5048);

// Samples are numbered along each axis of the domain; a number and a fraction is a place between two.

// A place [voxels], from its number.
vec3 placeOfSample(vec3 number) {
    return (number + kFirstSample) / float(samplesAcross());
}

// The number of a place [voxels].
vec3 numberOfSample(vec3 place) {
    return place * float(samplesAcross()) - kFirstSample;
}
