// The boundary that a ray is crossing, as it is kept in the ray's state.
#include "physics/fresnel.glsl"
#include "physics/boundary.glsl"
#include "viewer/ray_states.glsl"

// `nBefore`: index at the sample before.
Crossing crossingOf(RayState ray, float nBefore) {
    return Crossing(ray.crossingNormal, abs(ray.crossingWeight), ray.crossingAlong, ray.crossingGradMax, ray.crossingStart, nBefore,
                    sign(ray.crossingWeight));
}

void setCrossing(inout RayState ray, Crossing crossing) {
    ray.crossingNormal = crossing.normal;
    ray.crossingWeight = crossing.sideAtStart * crossing.weight;
    ray.crossingAlong = crossing.along;
    ray.crossingGradMax = crossing.gradMax;
    ray.crossingStart = crossing.nStart;
}
