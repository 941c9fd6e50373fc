// Radiance of the environment by direction of view: the mean over a solid angle about it [sr], which is 0 but behind rough
// boundaries. There a sample looks at its part of the lobe, not at a point in it: M. Colbert, J. Krivanek, "GPU-Based Importance
// Sampling", GPU Gems 3 (2007). A small lamp is so a weak gleam in many samples rather than a speckle in one.
#include "physics/environment.glsl"
#include "shared/view_blocks.h"

#if !defined(EFFECT_ENVIRONMENT)
vec3 background(vec3 direction, float solidAngle) {
    return vec3(0.0);
}
#elif defined(ENVIRONMENT_IMAGE)
layout(binding = kUnitEnvironment) uniform sampler2D environmentMap;

// Of the map's levels, each with texels of four times the solid angle of the one before: where a texel is as large.
float levelOf(vec3 direction, float solidAngle) {
    vec2 size = vec2(textureSize(environmentMap, 0));
    float row = sqrt(max(1.0 - direction.y * direction.y, 1.0e-12));
    float texel = 2.0 * kHalfTurn * kHalfTurn / (size.x * size.y) * row;
    return 0.5 * log2(max(solidAngle / texel, 1.0));
}

vec3 background(vec3 direction, float solidAngle) {
    vec2 uv = latLongFromDirection(turnedAboutY(direction, view.environmentAngle));
    return textureLod(environmentMap, uv, levelOf(direction, solidAngle)).rgb * view.environmentScale;
}
#else
vec3 background(vec3 direction, float solidAngle) {
    return gradientRadiance(direction, view.horizon, view.zenith);
}
#endif
