// What a ray sees at its end: the environment, or an opaque surface.
#include "viewer/ray_states.glsl"
#include "fields/fields.glsl"
#include "physics/phase.glsl"
#include "viewer/background.glsl"
#include "viewer/surface_light.glsl"

#ifdef EFFECT_OPAQUE

float depthAt(vec3 x) {
    return sampleOpaque(x).a;
}

#include "physics/surface_normal.glsl"

// Mean radiance of the environment over the hemisphere of a normal, weighted by the cosine: a blend of the values about
// the axes. Nothing shades it.
vec3 ambientRadiance(vec3 normal) {
    vec3 weight = normal * normal;
    return weight.x * viewGiven.ambient[normal.x >= 0.0 ? 0 : 1].rgb + weight.y * viewGiven.ambient[normal.y >= 0.0 ? 2 : 3].rgb +
           weight.z * viewGiven.ambient[normal.z >= 0.0 ? 4 : 5].rgb;
}

// A diffuse surface under the baked light, looked up a voxel off it, and under the environment.
vec3 surfaceRadiance(vec3 x, vec3 normal) {
    vec3 received = ambientRadiance(normal);
#ifdef BAKED_LIGHT
    received += fluxOnto(x + normal * view.opaqueOffset, normal) / kPi;
#endif
    // Coverage thins out over the last voxel of an object, and its albedo with it is only certain inside.
    return sampleOpaque(x - 0.5 * normal * voxelAt(x)).rgb * received;
}

#endif

// Of the surface at the ray's end; 0 where there is none.
vec3 normalAtEnd(RayState ray) {
#ifdef EFFECT_OPAQUE
    if (ray.status == kHitOpaque) {
        return outwardNormal(ray.x, voxelAt(ray.x), unitDirection(ray));
    }
#endif
    return vec3(0.0);
}

vec3 radianceBehind(RayState ray, vec3 normal, float spread) {
#ifdef EFFECT_OPAQUE
    if (ray.status == kHitOpaque) {
        return surfaceRadiance(ray.x, normal) / (ray.n * ray.n);
    }
#endif
    return ray.status == kAttenuated ? vec3(0.0) : background(unitDirection(ray), spread);
}

// Makes the pixel's radiance of basic radiance. `spread`: solid angle of what is seen [sr].
void seeEnd(inout RayState ray, float spread) {
    vec3 normal = normalAtEnd(ray);
    vec3 basic = ray.radiance + rayThroughput(ray) * radianceBehind(ray, normal, spread);
    ray.crossingNormal = normal;
    ray.radiance = ray.nCamera * ray.nCamera * basic;
}
