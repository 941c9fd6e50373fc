// How many samples of each voxel that opaque matter cuts lie in front of it: a byte a voxel, four to a word.
layout(std430, binding = TUBE_FREE_SAMPLES_BINDING) buffer FreeSampleBlock { uint freeSamples[]; };

const uint kVoxelsPerWord = 4u;
const uint kBitsPerVoxel = 8u;

uint freeSamplesIn(ivec3 voxel) {
    uint number = (uint(voxel.z) * uint(domain.size.y) + uint(voxel.y)) * uint(domain.size.x) + uint(voxel.x);
    return freeSamples[number / kVoxelsPerWord] >> (kBitsPerVoxel * (number % kVoxelsPerWord)) & ((1u << kBitsPerVoxel) - 1u);
}
