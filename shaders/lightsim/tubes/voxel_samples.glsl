// The samples that a voxel's mean is taken from.

struct VoxelSamples {
    int across;   // along each axis
    float share;  // of the voxel's light that each stands for
};

#ifdef EFFECT_OPAQUE
#include "fields/fields.glsl"
#include "fields/opaque_path.glsl"

// In voxels that opaque matter cuts, so that an eighth of a voxel is seen.
const int kLeastAcrossCut = 4;

int mostSamplesAcross() {
    return max(int(tube.samplesPerVoxel), kLeastAcrossCut);
}

// Of a voxel that matter cuts, samples in front of it stand for all that is free: whatever that is, even light leaves an even
// irradiance.
VoxelSamples samplesOf(ivec3 voxel) {
    float free = 1.0 - texelFetch(opaqueGrid, voxel, 0).a;
    int n = free < 1.0 ? mostSamplesAcross() : int(tube.samplesPerVoxel);
    float share = 1.0 / float(n * n * n);
    if (free == 1.0) {
        return VoxelSamples(n, share);
    }
    int freeSamples = 0;
    for (int i = 0; i < n * n * n; ++i) {
        vec3 place = (vec3(ivec3(i % n, i / n % n, i / (n * n))) + 0.5) / float(n);
        freeSamples += isSolid(domain.min + (vec3(voxel) + place) * domain.voxel) ? 0 : 1;
    }
    return VoxelSamples(n, freeSamples > 0 ? free / float(freeSamples) : share);
}
#else
int mostSamplesAcross() {
    return int(tube.samplesPerVoxel);
}

VoxelSamples samplesOf(ivec3 voxel) {
    int n = int(tube.samplesPerVoxel);
    return VoxelSamples(n, 1.0 / float(n * n * n));
}
#endif
