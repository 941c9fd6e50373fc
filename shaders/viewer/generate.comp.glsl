// Camera rays, or rays that are given, moved to where they enter the domain; there |w| = n, since its faces do not refract.
#include "viewer/ray_states.glsl"
#include "fields/fields.glsl"
#include "physics/box.glsl"
#ifdef LENS
#include "physics/lens.glsl"
#include "viewer/lens.glsl"
#endif

layout(local_size_x = kRaysPerGroup) in;

#ifdef RAYS_GIVEN
layout(std430, binding = kStorageGiven) readonly buffer Given { GivenRay given[]; };
#endif

RayState rayAt(vec3 origin, vec3 direction) {
    RayState ray = newRay(origin, direction);
    ray.status = kMissed;
    ray.entryDistance = uintBitsToFloat(0x7f800000u);
    return ray;
}

RayState enterDomain(RayState ray) {
    BoxSpan span = boxSpan(ray.x, ray.w, domainMin, domainMax);
    float enter = max(span.enter, 0.0);
    if (span.leave <= enter) {
        return ray;
    }
    RayState entered = ray;
    entered.status = kMarching;
    entered.x = clamp(ray.x + ray.w * enter, domainMin, domainMax);
    entered.n = sampleOptics(entered.x).n;
    entered.crossingStart = entered.n;
    entered.w = ray.w * entered.n;
    entered.evaluations = 1u;
    entered.entryDistance = enter;
#ifdef EFFECT_DISPERSION
    entered.dispersed |= uint(hasMetDispersion);
#endif
    entered.nCamera = span.enter <= 0.0 ? entered.n : 1.0;
    return entered;
}

RayState initialRay(uint index) {
#ifdef RAYS_GIVEN
    return rayAt(given[index].origin, given[index].direction);
#else
    ivec2 pixel = tileOrigin + tilePixel(index);
    vec2 screen = 2.0 * (vec2(pixel) + subPixel) / vec2(imageSize) - 1.0;
    vec3 through = cameraForward + cameraRight * screen.x - cameraUp * screen.y;
#ifdef LENS
    vec2 place = lensPlace(pixel);
    vec3 offset = place.x * normalize(cameraRight) + place.y * normalize(cameraUp);
    LensRay ray = thinLensRay(cameraPosition, through, focusDistance, offset);
    return rayAt(ray.origin, ray.direction);
#else
    return rayAt(cameraPosition, normalize(through));
#endif
#endif
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index < rayCount && isFollowed(rays[index])) {
        rays[index] = enterDomain(initialRay(index));
    }
}
