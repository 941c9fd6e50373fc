// Radiance of the environment by direction of view.
#include "physics/environment.glsl"
#include "shared/view_blocks.h"

#if !defined(EFFECT_ENVIRONMENT)
vec3 background(vec3 direction) {
    return vec3(0.0);
}
#elif defined(ENVIRONMENT_IMAGE)
layout(binding = kUnitEnvironment) uniform sampler2D environmentMap;

vec3 background(vec3 direction) {
    vec2 uv = latLongFromDirection(turnedAboutY(direction, view.environmentAngle));
    return textureLod(environmentMap, uv, 0.0).rgb * view.environmentScale;
}
#else
vec3 background(vec3 direction) {
    return gradientRadiance(direction, view.horizon, view.zenith);
}
#endif
