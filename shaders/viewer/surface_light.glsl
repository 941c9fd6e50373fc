// The baked light that falls on an opaque surface. A voxel that matter cuts holds the mean over what is free of it, and the
// less that is the less it says: the light off a surface is the mean over the free volume about a point, each of the voxels
// that interpolation joins there weighing by its free share. Flux and irradiance add up; their ratio does not.
#include "viewer/light.glsl"

#if defined(EFFECT_OPAQUE) && defined(BAKED_LIGHT)

float freeShare(vec3 x) {
    return 1.0 - shareOfDepth(sampleOpaque(x).a);
}

// Power per unit area of the surface, by band: |F·n| of the flux against the outward normal.
vec3 fluxOnto(vec3 x, vec3 normal) {
    ivec3 size = textureSize(irradianceGrid, 0);
    vec3 position = (x - view.lightMin) * view.lightScale * vec3(size) - 0.5;
    vec3 base = floor(position);
    vec3 irradiance = vec3(0.0);
    vec3 flux = vec3(0.0);
    float volume = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        vec3 upper = vec3(corner & 1, (corner >> 1) & 1, corner >> 2);
        vec3 share = mix(1.0 - (position - base), position - base, upper);
        ivec3 voxel = clamp(ivec3(base + upper), ivec3(0), size - 1);
        float weight = share.x * share.y * share.z *
                       freeShare(view.lightMin + (vec3(voxel) + 0.5) / (view.lightScale * vec3(size)));
        vec3 held = weight * texelFetch(irradianceGrid, voxel, 0).rgb;
        irradiance += held;
        flux += (held.r + held.g + held.b) * texelFetch(lightDirectionGrid, voxel, 0).rgb;
        volume += weight;
    }
    float total = irradiance.r + irradiance.g + irradiance.b;
    return total > 0.0 ? irradiance / volume * (max(-dot(flux, normal), 0.0) / total) : vec3(0.0);
}

#endif
