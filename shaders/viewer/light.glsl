// The baked light at a world position.
#include "fields/trilinear.glsl"
#include "physics/phase.glsl"
#include "shared/view_blocks.h"

#ifdef ANISOTROPY_BY_BAND
#define Anisotropy vec3
#else
#define Anisotropy float
#endif

#ifdef BAKED_LIGHT
layout(binding = kUnitIrradiance) uniform sampler3D irradianceGrid;
layout(binding = kUnitLightDirection) uniform sampler3D lightDirectionGrid;

// Scalar irradiance [power / scene unit^2].
vec3 sampleIrradiance(vec3 x) {
    return sampleTrilinear(irradianceGrid, (x - view.lightMin) * view.lightScale).rgb;
}

// Flux vector over scalar irradiance.
vec3 sampleLightDirection(vec3 x) {
    return sampleTrilinear(lightDirectionGrid, (x - view.lightMin) * view.lightScale).rgb;
}

// Irradiance times phase function, summed over arrivals, of light that is scattered against the direction of view.
#ifdef ISOTROPIC_SCATTERING
vec3 phasedIrradiance(vec3 x, vec3 viewDirection, Anisotropy g) {
    return sampleIrradiance(x) * henyeyGreenstein(0.0, 0.0);
}
#else
#ifdef LIGHT_LOBES
#include "viewer/lobes.glsl"
#endif

vec3 phasedIrradiance(vec3 x, vec3 viewDirection, Anisotropy g) {
    vec4 direction = sampleTrilinear(lightDirectionGrid, (x - view.lightMin) * view.lightScale);
#ifdef LIGHT_LOBES
    if (direction.a > 0.0) {  // one of the voxels about x at least has lobes
        return phasedLobes(x, viewDirection, g);
    }
#endif
    return sampleIrradiance(x) * phaseOfFlux(viewDirection, direction.rgb, g);
}
#endif
#endif
