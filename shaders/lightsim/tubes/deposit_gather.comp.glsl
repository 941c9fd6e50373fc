// Deposit, of parts in which irradiance is even: each sample point of a voxel that lies inside gets power x length over the
// volume there, found by inverting the map of the part (Newton). Neighbouring cells share their faces, so that every sample
// gets one value from each sheet of the wavefront, none twice.
#include "lightsim/tubes/deposit.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

const int kNewtonSteps = 4;
const float kNewtonEnd = 0.01;  // of the unit cube: what is left after such a step is of the order of its square
const float kFarOut = 1.0;  // of a unit cube, from its middle, where the linear guess may be off

// Solves placeIn(map, q) = x. Where it has no solution the result is outside the unit cube, or far from x.
vec3 invertedIn(Trilinear map, vec3 x, vec3 guess) {
    vec3 q = guess;
    for (int i = 0; i < kNewtonSteps; ++i) {
        mat3 d = derivativesIn(map, q);
        vec3 rest = x - placeIn(map, q);
        vec3 across = cross(d[1], d[2]);
        float volume = dot(d[0], across);
        if (volume == 0.0) {
            return vec3(-1.0);
        }
        vec3 change = vec3(dot(across, rest), dot(cross(d[2], d[0]), rest), dot(cross(d[0], d[1]), rest)) / volume;
        q += change;
        if (largestOf(abs(change)) < kNewtonEnd) {
            break;
        }
    }
    return q;
}

struct Light {
    vec3 powerLength;
    vec3 flux;
};

// Light of the part at the samples of a voxel.
Light gathered(Part part, CornerLight corners, Trilinear map, mat3 inverseMiddle, vec3 middle, ivec3 voxel) {
    Light light = Light(vec3(0.0), vec3(0.0));
    int n = int(tube.samplesPerVoxel);
    for (int i = 0; i < n * n * n; ++i) {
        vec3 x = vec3(voxel) + (vec3(ivec3(i % n, i / n % n, i / (n * n))) + 0.5) / float(n);
        vec3 guess = inverseMiddle * (x - middle);
        if (largestOf(abs(guess)) > kFarOut) {
            continue;
        }
        vec3 q = invertedIn(map, x, guess + 0.5);
        if (all(greaterThanEqual(q, vec3(0.0))) && all(lessThan(q, vec3(1.0)))) {
            vec3 place = placeInCell(part, q);
            if (!isPastMirror(part.cell, place)) {
                continue;
            }
            mat3 d = derivativesIn(map, q);
            float own = abs(determinant(d)) * float(part.cuts.x * part.cuts.y * part.cuts.z);
            vec3 powerLength = powerLengthAt(corners, place) / (volumeAt(part.cell, place, own) * float(n * n * n));
            light.powerLength += powerLength;
            light.flux += fluxOf(powerLength, unitOf(d[2]));
        }
    }
    return light;
}

void main() {
    if (gl_GlobalInvocationID.x >= header.lists[TUBE_GATHER_LIST].count) {
        return;
    }
    Part part = unpackedPart(listedPart(TUBE_GATHER_LIST, gl_GlobalInvocationID.x));
    Trilinear map = partOf(mapOf(part.cell), part.cuts, part.index);
    CornerLight corners = cornerLightOf(part.cell);
    vec3 low = vec3(1.0e30);
    vec3 high = vec3(-1.0e30);
    for (int i = 0; i < 8; ++i) {
        vec3 x = placeIn(map, vec3(ivec3(i & 1, i >> 1 & 1, i >> 2)));
        low = min(low, x);
        high = max(high, x);
    }
    // voxels that have a sample between low and high
    float rim = 0.5 / float(tube.samplesPerVoxel);
    ivec3 first = max(ivec3(ceil(low + rim)) - 1, ivec3(0));
    ivec3 count = min(ivec3(floor(high - rim)), domainSize - 1) - first + 1;
    if (any(lessThan(count, ivec3(1)))) {
        return;
    }
    vec3 middle = placeIn(map, vec3(0.5));
    mat3 inverseMiddle = inverse(derivativesIn(map, vec3(0.5)));
    // half the extent of a voxel in the unit cube, by the linear guess
    mat3 rows = transpose(inverseMiddle);
    vec3 voxelReach = 0.5 * vec3(dot(abs(rows[0]), vec3(1.0)), dot(abs(rows[1]), vec3(1.0)), dot(abs(rows[2]), vec3(1.0)));
    for (int i = 0; i < count.x * count.y * count.z; ++i) {
        ivec3 voxel = first + ivec3(i % count.x, i / count.x % count.y, i / (count.x * count.y));
        if (!takesLight(voxel) || any(greaterThan(abs(inverseMiddle * (vec3(voxel) + 0.5 - middle)), voxelReach + kFarOut))) {
            continue;
        }
        Light light = gathered(part, corners, map, inverseMiddle, middle, voxel);
        if (largestOf(light.powerLength) > 0.0) {
            addAt(voxel, light.powerLength, light.flux);
        }
    }
}
