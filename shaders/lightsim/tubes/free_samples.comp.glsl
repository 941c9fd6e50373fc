// Counts the samples in front of opaque matter, an invocation a word of voxels.
#define CUT_VOXELS
#include "lightsim/tubes/tubes.glsl"
#include "lightsim/tubes/voxel_samples.glsl"
#include "fields/opaque_path.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

uint freeSamplesOf(ivec3 voxel) {
    const int n = TUBE_SAMPLES_ACROSS_CUT;
    uint count = 0u;
    for (int i = 0; i < n * n * n && isCut(voxel); ++i) {
        ivec3 number = voxel * n + ivec3(i % n, i / n % n, i / (n * n));
        count += isSolid(domain.min + placeOfSample(vec3(number)) * domain.voxel) ? 0u : 1u;
    }
    return count;
}

void main() {
    uint word = gl_GlobalInvocationID.x;
    if (word >= tube.itemCount) {
        return;
    }
    uint size = uint(domain.size.x * domain.size.y * domain.size.z);
    uint counts = 0u;
    for (uint i = 0u; i < kVoxelsPerWord; ++i) {
        uint number = word * kVoxelsPerWord + i;
        uvec2 across = uvec2(domain.size.xy);
        ivec3 voxel = ivec3(number % across.x, number / across.x % across.y, number / (across.x * across.y));
        counts |= number < size ? freeSamplesOf(voxel) << (kBitsPerVoxel * i) : 0u;
    }
    freeSamples[word] = counts;
}
