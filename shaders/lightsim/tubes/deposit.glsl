// What both deposits of parts of cells share: the parts, the sums, and the light at a place of a cell.
#include "lightsim/tubes/records.glsl"
#include "lightsim/sums.glsl"

// Power x arc length of the steps [voxels] at the corners of a cell, by band, in units of the sums; of those after the steps, over
// what matter leaves on the whole.
struct CornerLight {
    vec3 powerLength[8];
    vec3 fall;  // binary logarithm of that
};

#if defined(EFFECT_ABSORPTION) || defined(EFFECT_SCATTERING)
// Light falls as an exponential in matter; to or from nothing, as a straight line.
void takeOutFall(inout CornerLight light) {
    const float kLeast = 1.0e-3;
    vec3 first = light.powerLength[0] + light.powerLength[1] + light.powerLength[2] + light.powerLength[3];
    vec3 last = light.powerLength[4] + light.powerLength[5] + light.powerLength[6] + light.powerLength[7];
    bvec3 falls = greaterThan(min(first, last), kLeast * max(first, last));
    light.fall = mix(vec3(0.0), log2(max(last, vec3(1.0e-30)) / max(first, vec3(1.0e-30))), falls);
    vec3 perFall = exp2(-light.fall);
    for (int i = 4; i < 8; ++i) {
        light.powerLength[i] *= perFall;
    }
}
#else
void takeOutFall(inout CornerLight light) {
    light.fall = vec3(0.0);
}
#endif

CornerLight cornerLightOf(uint cell) {
    CornerLight light;
    vec3 scaled = cellRow(cell, kPowerRow).rgb * settings.depositScale;
#if BANDS == 3
    for (int i = 0; i < 8; ++i) {
        light.powerLength[i] = scaled * cellRow(cell, kFirstShareRow + i).rgb * cornerOf(cell, i % 4 + 4).w;
    }
#else
    vec4 before = cellRow(cell, kFirstShareRow);
    vec4 after = cellRow(cell, kFirstShareRow + 1);
    for (int i = 0; i < 4; ++i) {
        vec3 powerLength = scaled * cornerOf(cell, i + 4).w;
        light.powerLength[i] = powerLength * before[i];
        light.powerLength[i + 4] = powerLength * after[i];
    }
#endif
    takeOutFall(light);
    return light;
}

// Roots of the volumes at the corners of a cell before and after its steps.
struct CornerVolumes {
    vec4 before, after;
};

CornerVolumes cornerVolumesOf(uint cell) {
    return CornerVolumes(cellRow(cell, kFirstVolumeRow), cellRow(cell, kFirstVolumeRow + 1));
}

// Volume of the cell per u, v and t at a place of it, over the relative power there [voxels^3]: where the node's parabolas
// are no good, `own`. Its root is linear along straight rays of a spherical front.
float volumeAt(CornerVolumes volumes, vec3 at, float own) {
    if (volumes.before.x < 0.0) {
        return own;
    }
    vec4 roots = mix(volumes.before, volumes.after, at.z);
    float root = mix(mix(roots.x, roots.y, at.x), mix(roots.z, roots.w, at.x), at.y);
    return root * root;
}

vec3 bilinear(vec3 a, vec3 b, vec3 c, vec3 d, vec2 at) {
    return mix(mix(a, b, at.x), mix(c, d, at.x), at.y);
}

// What matter leaves, t from 0 to 1 along the steps.
vec3 leftAt(CornerLight light, float t) {
#if defined(EFFECT_ABSORPTION) || defined(EFFECT_SCATTERING)
    return exp2(light.fall * t);
#else
    return vec3(1.0);
#endif
}

// Power x arc length at a place of the cell, per unit of u and v.
vec3 powerLengthAt(CornerLight light, vec3 at) {
    vec3 first = bilinear(light.powerLength[0], light.powerLength[1], light.powerLength[2], light.powerLength[3], at.xy);
    vec3 last = bilinear(light.powerLength[4], light.powerLength[5], light.powerLength[6], light.powerLength[7], at.xy);
    return mix(first, last, at.z) * leftAt(light, at.z);
}

vec3 unitOf(vec3 v) {
    return v / max(length(v), 1.0e-30);
}

void addWhereInside(ivec3 voxel, vec3 powerLength, vec3 flux) {
    if (all(greaterThanEqual(voxel, ivec3(0))) && all(lessThan(voxel, domain.size))) {
        addAt(voxel, powerLength, flux);
    }
}
