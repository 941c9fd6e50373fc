// The baked light at a world position.
#include "fields/trilinear.glsl"
#include "shared/view_blocks.h"

#ifdef BAKED_LIGHT
layout(binding = kUnitIrradiance) uniform sampler3D irradianceGrid;
layout(binding = kUnitLightDirection) uniform sampler3D lightDirectionGrid;

// Scalar irradiance [power / scene unit^2].
vec3 sampleIrradiance(vec3 x) {
    return sampleTrilinear(irradianceGrid, (x - lightMin) * lightScale).rgb;
}

// Flux vector over scalar irradiance.
vec3 sampleLightDirection(vec3 x) {
    return sampleTrilinear(lightDirectionGrid, (x - lightMin) * lightScale).rgb;
}
#endif
