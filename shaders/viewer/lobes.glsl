// Light of several directions (docs/physics.md, section 5). What lobes scatter is interpolated, not lobes: which of a voxel's
// belongs to which of its neighbour's has no answer where sheets wind about a focus.

layout(binding = kUnitLobes) uniform sampler2D lobeTable;

vec3 phasedLobe(ivec2 at, vec3 viewDirection, Anisotropy g) {
    vec3 irradiance = texelFetch(lobeTable, at, 0).rgb;
    return irradiance * phaseOfFlux(viewDirection, texelFetch(lobeTable, at + ivec2(1, 0), 0).rgb, g);
}

// Irradiance times phase function, summed over the lobes of a voxel.
vec3 phasedLight(ivec3 voxel, vec3 viewDirection, Anisotropy g) {
    vec4 direction = texelFetch(lightDirectionGrid, voxel, 0);
    if (direction.a == 0.0) {
        return texelFetch(irradianceGrid, voxel, 0).rgb * phaseOfFlux(viewDirection, direction.rgb, g);
    }
    int row = int(direction.a) - 1;
    ivec2 at = ivec2(row % kLobeRowsAcross * (kLobesPerRow * kTexelsPerLobe), row / kLobeRowsAcross);
    return phasedLobe(at, viewDirection, g) + phasedLobe(at + ivec2(kTexelsPerLobe, 0), viewDirection, g) +
           phasedLobe(at + ivec2(2 * kTexelsPerLobe, 0), viewDirection, g);
}

// Trilinear mean of what the voxels about x scatter.
vec3 phasedLobes(vec3 x, vec3 viewDirection, Anisotropy g) {
    ivec3 size = textureSize(lightDirectionGrid, 0);
    vec3 position = (x - view.lightMin) * view.lightScale * vec3(size) - 0.5;
    vec3 base = floor(position);
    vec3 t = position - base;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 8; ++i) {
        ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
        vec3 weight = mix(1.0 - t, t, vec3(corner));
        ivec3 voxel = clamp(ivec3(base) + corner, ivec3(0), size - 1);
        sum += weight.x * weight.y * weight.z * phasedLight(voxel, viewDirection, g);
    }
    return sum;
}
