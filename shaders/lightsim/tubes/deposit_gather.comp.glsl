// Deposit, of parts in which irradiance is even: each sample point of a voxel that lies inside gets power x length over the
// volume there, found by inverting the map of the part (Newton), once for those of a row in a voxel. Neighbouring cells share their
// faces, so that every sample gets one value from each sheet of the wavefront, none twice.
// Voxels that opaque matter cuts have samples of their own (CUT_VOXELS).
#include "lightsim/tubes/deposit.glsl"
#include "lightsim/tubes/voxel_samples.glsl"
#include "lightsim/tubes/group_order.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

#ifdef CUT_VOXELS
const uint kList = TUBE_CUT_LIST;
#else
const uint kList = TUBE_GATHER_LIST;
#endif

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
        float perVolume = 1.0 / volume;
        vec3 change = vec3(dot(across, rest), dot(cross(d[2], d[0]), rest), dot(cross(d[0], d[1]), rest)) * perVolume;
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

// A part, and what a linear guess of the place of a sample in it takes. Lengths in spacings of samples, places by their numbers from
// a voxel of its cell on.
struct Gather {
    Part part;
    vec3 origin;         // of that voxel [voxels]
    vec3 perCut;         // over cuts along u, v, t
    Trilinear map;
    CornerVolumes volumes;
    float volumeInCell;  // [voxels^3] of a unit of the map's, were the part the whole cell
    vec3 middle;
    mat3 inverseMiddle;  // of the derivatives there
    vec3 reach;          // how far from the middle of the unit cube the guess for a point of the part can be
};

// About its middle the map is linear but for products of two and of three coordinates, each at most a half.
Gather gatherOf(Part part, Trilinear map, vec3 origin) {
    const float kRounding = 1.0e-3;
    Gather gather;
    gather.part = part;
    gather.origin = origin;
    gather.perCut = 1.0 / vec3(part.cuts);
    gather.volumes = cornerVolumesOf(part.cell);
    float across = float(samplesAcross());
    gather.volumeInCell = float(part.cuts.x * part.cuts.y * part.cuts.z) / (across * across * across);
    gather.map = map;
    gather.middle = placeIn(map, vec3(0.5));
    gather.inverseMiddle = inverse(derivativesIn(map, vec3(0.5)));
    vec3 products = abs(gather.inverseMiddle * (map.c110 + 0.5 * map.c111)) +
                    abs(gather.inverseMiddle * (map.c101 + 0.5 * map.c111)) +
                    abs(gather.inverseMiddle * (map.c011 + 0.5 * map.c111)) + 0.5 * abs(gather.inverseMiddle * map.c111);
    gather.reach = 0.5 + kRounding + 0.25 * products;
    return gather;
}

// A row's places in the unit cube of a part about one of them, to second order in the samples from there.
struct Passage {
    vec3 q, perSample, perSquare;
    float volume;  // of the map at q
};

Passage passageAt(Gather gather, vec3 number) {
    vec3 guess = gather.inverseMiddle * (number - gather.middle);
    Passage passage;
    passage.q = invertedIn(gather.map, number, guess + 0.5);
    mat3 d = derivativesIn(gather.map, passage.q);
    mat3 across = mat3(cross(d[1], d[2]), cross(d[2], d[0]), cross(d[0], d[1]));
    passage.volume = dot(d[0], across[0]);
    float perVolume = 1.0 / passage.volume;
    vec3 a = vec3(across[0].x, across[1].x, across[2].x) * perVolume;
    Trilinear map = gather.map;
    vec3 bend = (map.c110 + map.c111 * passage.q.z) * (a.x * a.y) + (map.c101 + map.c111 * passage.q.y) * (a.x * a.z) +
                (map.c011 + map.c111 * passage.q.x) * (a.y * a.z);
    passage.perSample = a;
    passage.perSquare = -(bend * across) * perVolume;
    return passage;
}

vec3 placeIn(Passage passage, float samples) {
    return passage.q + samples * (passage.perSample + samples * passage.perSquare);
}

// Light of the part at samples of a row, shares of that of their voxel: as many times what there is in their middle.
Light lightOf(Gather gather, CornerLight corners, vec2 row, float first, float end, float share) {
    Light light = Light(vec3(0.0), vec3(0.0));
    float middle = 0.5 * (first + end - 1.0);
    Passage passage = passageAt(gather, vec3(middle, row));
    float count = 0.0;
    float sum = 0.0;
    for (float next = first; next < end; next += 1.0) {
        vec3 q = placeIn(passage, next - middle);
        vec3 place = (vec3(gather.part.index) + q) * gather.perCut;
        if (all(greaterThanEqual(q, vec3(0.0))) && all(lessThan(q, vec3(1.0))) && isLit(gather.part.cell, place)) {
            count += 1.0;
            sum += next - middle;
        }
    }
    if (count > 0.0) {
        vec3 q = placeIn(passage, sum / count);
        vec3 place = (vec3(gather.part.index) + q) * gather.perCut;
        float own = abs(passage.volume) * gather.volumeInCell;
        light.powerLength = powerLengthAt(corners, place) * (count * share / volumeAt(gather.volumes, place, own));
        light.flux = fluxOf(light.powerLength, unitOf(derivativesIn(gather.map, q)[2]));
    }
    return light;
}

// Of places [voxels], or of numbers of samples.
struct Box {
    vec3 first, end;
};

// About a part whose map is from `origin` on, as far as it is in the slab.
Box boxOf(Trilinear map, vec3 origin) {
    Box box = Box(vec3(1.0e30), vec3(-1.0e30));
    for (int i = 0; i < 8; ++i) {
        vec3 x = placeIn(map, vec3(ivec3(i & 1, i >> 1 & 1, i >> 2)));
        box.first = min(box.first, x);
        box.end = max(box.end, x);
    }
    box.first = max(box.first, vec3(0.0, 0.0, float(settings.slabBegin)) - origin);
    box.end = min(box.end, vec3(domain.size.xy, settings.slabEnd) - origin);
    return box;
}

// With those that rounding may leave out.
Box samplesIn(Box box) {
    const float kRounding = 1.0e-3;
    return Box(ceil(numberOfSample(box.first) - kRounding), floor(numberOfSample(box.end) + kRounding) + 1.0);
}

// The map to numbers of samples.
Trilinear numbered(Trilinear map) {
    float across = float(samplesAcross());
    return Trilinear(numberOfSample(map.c000), across * map.c100, across * map.c010, across * map.c001, across * map.c110,
                     across * map.c101, across * map.c011, across * map.c111);
}

// Rows of samples along x, one of so many that share a part.
struct Rows {
    Box box;
    float perAcross;  // over samples of the box along y
    // Where the faces across u, v and t of the guess's reach cut a row: between both in the middle, which is linear in the row's
    // y and z from those of the part's middle, and as far from it as `reach`.
    vec2 origin;
    vec3 middle, middlePerY, middlePerZ;
    vec3 reach;
};

Rows rowsOf(Gather gather, Box box) {
    vec3 along = gather.inverseMiddle[0];
    vec3 perSample = 1.0 / mix(along, vec3(1.0e-20), lessThan(abs(along), vec3(1.0e-20)));
    Rows rows;
    rows.box = box;
    rows.perAcross = 1.0 / (box.end.y - box.first.y);
    rows.origin = gather.middle.yz;
    rows.middle = gather.middle.x * (along * perSample);
    rows.middlePerY = -gather.inverseMiddle[1] * perSample;
    rows.middlePerZ = -gather.inverseMiddle[2] * perSample;
    rows.reach = gather.reach * abs(perSample);
    return rows;
}

// Samples of a row that may lie in a part.
struct Row {
    vec2 number;  // along y and z
    float next, end;
};

Row rowAt(vec2 number, Rows rows) {
    vec2 from = number - rows.origin;
    vec3 middle = rows.middle + rows.middlePerY * from.x + rows.middlePerZ * from.y;
    return Row(number, max(ceil(largestOf(middle - rows.reach)), rows.box.first.x),
               min(floor(-largestOf(-middle - rows.reach)) + 1.0, rows.box.end.x));
}

// Not of a row without numbers, of a part whose map cannot be inverted.
bool hasSamplesLeft(Row row) {
    return row.next < row.end;
}

// So many rows on, y first.
vec2 rowsOn(vec2 number, float count, Rows rows) {
    float along = number.x - rows.box.first.y + count;
    float layers = floor((along + 0.5) * rows.perAcross);
    return vec2(rows.box.first.y + along - layers * (rows.box.end.y - rows.box.first.y), number.y + layers);
}

// The first from this row on, of those that an invocation takes, that has samples left; beyond the last one z is too large.
Row withSamples(Row row, Rows rows) {
    while (!hasSamplesLeft(row) && row.number.y < rows.box.end.z) {
        row = rowAt(rowsOn(row.number, float(GATHERS_PER_PART), rows), rows);
    }
    return row;
}

// Adds what samples bring: those of a row in a voxel together, one such stretch after the other of row after row in one loop.
// Invocations wait for the one that has most to do in either loop.
void gatherFrom(Box box, Gather gather, CornerLight corners, uint firstRow) {
    vec3 extent = box.end - box.first;
    int most = int(extent.x * extent.y * extent.z);
    float across = float(samplesAcross());
    Rows rows = rowsOf(gather, box);
    Row row = withSamples(rowAt(rowsOn(box.first.yz, float(firstRow), rows), rows), rows);
    for (int i = 0; i < most && row.number.y < box.end.z; ++i) {
        vec3 fromOrigin = floor(placeOfSample(vec3(row.next, row.number)));
        ivec3 voxel = ivec3(gather.origin + fromOrigin);
        bool takes = takesLight(voxel) && hasSamples(voxel);
        float end = min(row.end, (fromOrigin.x + 1.0) * across);
        float share = sampleShareIn(voxel);
        Light light = lightOf(gather, corners, row.number, takes ? row.next : end, end, share);
        if (brightestOf(light.powerLength) > 0.0) {
            addAt(voxel, light.powerLength, light.flux);
        }
        row.next = end;
        row = withSamples(row, rows);
    }
}

// Samples in a part, about; none of one that is not listed.
float workOf(uint index) {
    if (index >= header.lists[kList].count) {
        return 0.0;
    }
    Part part = unpackedPart(listedPart(kList, index));
    float across = float(samplesAcross());
    return volumeOf(part.cell) * across * across * across / float(part.cuts.x * part.cuts.y * part.cuts.z);
}

void main() {
#if GATHERS_PER_PART == 1
    uint index = inOrderOf(workOf(gl_GlobalInvocationID.x));
#else
    uint index = gl_GlobalInvocationID.x / uint(GATHERS_PER_PART);
#endif
    uint firstRow = gl_GlobalInvocationID.x % uint(GATHERS_PER_PART);
    if (index >= header.lists[kList].count) {
        return;
    }
    uint packed_ = listedPart(kList, index);
    Part part = unpackedPart(packed_);
    // Neighbours look at the same sample from either side of their face: far from 0 rounding could give it to both or to neither.
    vec3 origin = floor(cornerOf(part.cell, 0).xyz);
    Trilinear map = mapOf(part.cell);
    map.c000 -= origin;
    map = partOf(map, part.cuts, part.index);
    Box box = boxOf(map, origin);
#if defined(EFFECT_OPAQUE) && !defined(CUT_VOXELS)
    if (firstRow == 0u && meetsCutVoxel(box.first + origin, box.end + origin)) {
        listPart(TUBE_CUT_LIST, packed_);
    }
#endif
    Box samples = samplesIn(box);
    if (all(lessThan(samples.first, samples.end))) {
        gatherFrom(samples, gatherOf(part, numbered(map), origin), cornerLightOf(part.cell), firstRow);
    }
}
