// Camera rays, or rays that are given, moved to where they enter the domain; there |w| = n, since its faces do not refract.
#include "viewer/ray_states.glsl"
#include "fields/fields.glsl"
#include "physics/box.glsl"
#ifdef LENS
#include "physics/lens.glsl"
#include "viewer/lens.glsl"
#endif

RayState rayAt(vec3 origin, vec3 direction) {
    RayState ray = newRay(origin, direction);
    ray.status = kMissed;
    ray.entryDistance = uintBitsToFloat(0x7f800000u);
    return ray;
}

RayState enterDomain(RayState ray) {
    BoxSpan span = boxSpan(ray.x, ray.w, domain.min, domain.max);
    float enter = max(span.enter, 0.0);
    if (span.leave <= enter) {
        return ray;
    }
    RayState entered = ray;
    entered.status = kMarching;
    entered.x = clamp(ray.x + ray.w * enter, domain.min, domain.max);
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

#ifdef STRAIGHT_FLIGHTS
// A ray that meets nothing but vacuum on its way through the domain is at the end of it.
RayState passVacuum(RayState ray) {
    BoxSpan content = boxSpan(ray.x, ray.w, view.contentMin, view.contentMax);
    if (ray.status != kMarching || content.leave > max(content.enter, 0.0)) {
        return ray;
    }
    RayState ended = ray;
    vec3 direction = unitDirection(ray);
    ended.pathLength = distanceToExit(ray.x, direction, domain.min, domain.max);
    ended.opticalLength = ray.n * ended.pathLength;
    ended.x = clamp(ray.x + direction * ended.pathLength, domain.min, domain.max);
    ended.status = kExited;
    ended.lookUps = 1u;
    return ended;
}
#else
RayState passVacuum(RayState ray) {
    return ray;
}
#endif

#ifdef RAYS_GIVEN
layout(std430, binding = kStorageGiven) readonly buffer Given { GivenRay given[]; };

RayState initialRay(uint index) {
    return rayAt(given[index].origin, given[index].direction);
}
#else
RayState initialRay(uint index) {
    ivec2 pixel = view.tileOrigin + tilePixel(index);
    vec2 screen = 2.0 * (vec2(pixel) + view.subPixel) / vec2(view.imageSize) - 1.0;
    vec3 through = view.cameraForward + view.cameraRight * screen.x - view.cameraUp * screen.y;
#ifdef LENS
    vec2 place = lensPlace(pixel);
    vec3 offset = place.x * normalize(view.cameraRight) + place.y * normalize(view.cameraUp);
    LensRay ray = thinLensRay(view.cameraPosition, through, view.focusDistance, offset);
    return rayAt(ray.origin, ray.direction);
#else
    return rayAt(view.cameraPosition, normalize(through));
#endif
}
#endif

// The ray that begins at the camera or is given, where it enters the domain, or beyond it if it meets nothing.
RayState beginRay(uint index) {
    return passVacuum(enterDomain(initialRay(index)));
}
