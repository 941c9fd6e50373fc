// The film as a texture for the screen: tone-mapped, or in false colour by one of the ways to look.
#include "physics/box.glsl"
#include "physics/tone.glsl"
#include "viewer/film_pixels.glsl"
#include "shared/look_block.h"
#include "fields/fields.glsl"
#include "viewer/light.glsl"
#include "viewer/false_color.glsl"

layout(local_size_x = kRaysPerGroup) in;

#ifdef LOOK_ERROR
layout(binding = kUnitComparedFilm) uniform usamplerBuffer comparedTexels;
#endif
layout(rgba8, binding = kImagePicture) writeonly uniform image2D picture;

vec3 displayed(vec3 radiance) {
    vec3 exposed = radiance * view.exposureScale;
#if defined(TONE_AGX)
    exposed = toneAgx(exposed);
#elif defined(TONE_REINHARD)
    exposed = toneReinhard(exposed);
#endif
    return srgbEncoded3(exposed);
}

float onScale(float value) {
    return (value - lowest) / (highest - lowest);
}

#ifdef LOOK_SLICE

// The value of the grid that is looked at.
vec3 sliceColor(vec3 x) {
#if defined(LOOK_INDEX)
    return turbo(onScale(sampleOptics(x).n));
#elif defined(LOOK_DIRECTION) && defined(BAKED_LIGHT)
    return 0.5 + 0.5 * sampleLightDirection(x);
#elif defined(BAKED_LIGHT)
    return turbo(onScale(log2(max(dot(sampleIrradiance(x), vec3(1.0 / 3.0)), 1e-20))));
#else
    return vec3(0.0);
#endif
}

// A straight look at the plane, over the picture dimmed.
vec3 sliceOver(vec3 behind, ivec2 pixel) {
    vec2 screen = 2.0 * (vec2(pixel) + 0.5) / vec2(view.imageSize) - 1.0;
    vec3 ray = view.cameraForward + view.cameraRight * screen.x - view.cameraUp * screen.y;
    SlicePoint point = slicePoint(view.cameraPosition, ray, sliceAxis, slicePosition, domain.min, domain.max);
    return point.isMet ? sliceColor(point.x) : 0.25 * behind;
}

#endif

#ifdef LOOK_ERROR

// Difference from the film that this one is compared with [percent of the radiance].
float differencePercent(vec3 radiance, vec3 compared) {
    vec3 difference = abs(radiance - compared);
    float mean = dot(abs(radiance), vec3(1.0 / 3.0));
    return 100.0 * dot(difference, vec3(1.0 / 3.0)) / max(mean, 1e-20);
}

#endif

vec3 pictureColor(vec3 radiance, uint pixel, ivec2 at) {
#if defined(LOOK_ERROR)
    return turbo(onScale(differencePercent(radiance, filmRow(comparedTexels, pixel, kRadianceRow).rgb)));
#elif defined(LOOK_STEPS)
    return turbo(onScale(filmRow(filmTexels, pixel, kThroughputRow).a));
#elif defined(LOOK_RADIANCE)
    return turbo(onScale(log2(max(dot(radiance, vec3(1.0 / 3.0)), 1e-20))));
#elif defined(LOOK_SLICE)
    return sliceOver(displayed(radiance), at);
#else
    return displayed(radiance);
#endif
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= view.rayCount) {
        return;
    }
    ivec2 pixel = ivec2(int(index) % view.tileSize.x, int(index) / view.tileSize.x);
    imageStore(picture, pixel, vec4(pictureColor(filmRow(filmTexels, index, kRadianceRow).rgb, index, pixel), 1.0));
}
