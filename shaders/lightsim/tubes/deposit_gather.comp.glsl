// Deposit, of parts in which irradiance is even: each sample point of a voxel that lies inside gets power x length over the
// volume there, found by inverting the map of the part (Newton). Neighbouring cells share their faces, so that every sample
// gets one value from each sheet of the wavefront, none twice.
#include "lightsim/tubes/deposit.glsl"
#include "lightsim/tubes/voxel_samples.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

const int kNewtonSteps = 4;
const float kNewtonEnd = 0.01;  // of the unit cube: what is left after such a step is of the order of its square
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

// A part, and what a linear guess of the place of a point in it takes.
struct Gather {
    Part part;
    Trilinear map;
    vec3 middle;
    mat3 inverseMiddle;  // of the derivatives there
    vec3 reach;          // how far from the middle of the unit cube the guess for a point of the part can be
};

// About its middle the map is linear but for products of two and of three coordinates, each at most a half.
Gather gatherOf(Part part, Trilinear map) {
    const float kRounding = 1.0e-3;
    Gather gather;
    gather.part = part;
    gather.map = map;
    gather.middle = placeIn(map, vec3(0.5));
    gather.inverseMiddle = inverse(derivativesIn(map, vec3(0.5)));
    vec3 products = abs(gather.inverseMiddle * (map.c110 + 0.5 * map.c111)) +
                    abs(gather.inverseMiddle * (map.c101 + 0.5 * map.c111)) +
                    abs(gather.inverseMiddle * (map.c011 + 0.5 * map.c111)) + 0.5 * abs(gather.inverseMiddle * map.c111);
    gather.reach = 0.5 + kRounding + 0.25 * products;
    return gather;
}

// Light of the part at a point x, a share of that of its voxel.
Light lightAt(Gather gather, CornerLight corners, vec3 x, vec3 guess, float share) {
    Light light = Light(vec3(0.0), vec3(0.0));
    vec3 q = invertedIn(gather.map, x, guess + 0.5);
    vec3 place = placeInCell(gather.part, q);
    if (all(greaterThanEqual(q, vec3(0.0))) && all(lessThan(q, vec3(1.0))) && isLit(gather.part.cell, place)) {
        mat3 d = derivativesIn(gather.map, q);
        ivec3 cuts = gather.part.cuts;
        float own = abs(determinant(d)) * float(cuts.x * cuts.y * cuts.z);
        light.powerLength = powerLengthAt(corners, place) * (share / volumeAt(gather.part.cell, place, own));
        light.flux = fluxOf(light.powerLength, unitOf(d[2]));
    }
    return light;
}

// Light of the part at the samples of a voxel. Samples that cannot lie in it are passed over in a loop of their own, for
// invocations wait for each other in what follows it.
Light gathered(Gather gather, CornerLight corners, ivec3 voxel) {
    Light light = Light(vec3(0.0), vec3(0.0));
    VoxelSamples samples = samplesOf(voxel);
    int n = samples.across;
    float spacing = 1.0 / float(n);
    ivec3 first = ivec3(0);
    ivec3 last = ivec3(n - 1);
    ivec3 place = ivec3(-1, 0, 0);
    for (int i = 0; i < n * n * n; ++i) {
        vec3 x, guess;
        do {
            place = following(place, first, last);
            x = vec3(voxel) + (vec3(place) + 0.5) * spacing;
            guess = gather.inverseMiddle * (x - gather.middle);
        } while (place.z < n && any(greaterThan(abs(guess), gather.reach)));
        if (place.z >= n) {
            break;
        }
        Light more = lightAt(gather, corners, x, guess, samples.share);
        light.powerLength += more.powerLength;
        light.flux += more.flux;
    }
    return light;
}

// Half the extent of a voxel in the unit cube, by the linear guess.
vec3 voxelReachOf(Gather gather) {
    mat3 rows = transpose(gather.inverseMiddle);
    return 0.5 * vec3(dot(abs(rows[0]), vec3(1.0)), dot(abs(rows[1]), vec3(1.0)), dot(abs(rows[2]), vec3(1.0)));
}

void gatherBetween(ivec3 first, ivec3 last, Gather gather, CornerLight corners) {
    vec3 reach = gather.reach + voxelReachOf(gather);
    int count = (last.x - first.x + 1) * (last.y - first.y + 1) * (last.z - first.z + 1);
    ivec3 voxel = first - ivec3(1, 0, 0);
    for (int i = 0; i < count; ++i) {
        vec3 guess;
        do {
            voxel = following(voxel, first, last);
            guess = gather.inverseMiddle * (vec3(voxel) + 0.5 - gather.middle);
        } while (voxel.z <= last.z && (any(greaterThan(abs(guess), reach)) || !takesLight(voxel)));
        if (voxel.z > last.z) {
            break;
        }
        Light light = gathered(gather, corners, voxel);
        addAt(voxel, light.powerLength, light.flux);
    }
}

void main() {
    if (gl_GlobalInvocationID.x >= header.lists[TUBE_GATHER_LIST].count) {
        return;
    }
    Part part = unpackedPart(listedPart(TUBE_GATHER_LIST, gl_GlobalInvocationID.x));
    Trilinear map = partOf(mapOf(part.cell), part.cuts, part.index);
    vec3 low = vec3(1.0e30);
    vec3 high = vec3(-1.0e30);
    for (int i = 0; i < 8; ++i) {
        vec3 x = placeIn(map, vec3(ivec3(i & 1, i >> 1 & 1, i >> 2)));
        low = min(low, x);
        high = max(high, x);
    }
    // voxels that have a sample between low and high
    float rim = 0.5 / float(mostSamplesAcross());
    ivec3 first = max(ivec3(ceil(low + rim)) - 1, ivec3(0));
    ivec3 last = min(ivec3(floor(high - rim)), domain.size - 1);
    if (all(lessThanEqual(first, last))) {
        gatherBetween(first, last, gatherOf(part, map), cornerLightOf(part.cell));
    }
}
