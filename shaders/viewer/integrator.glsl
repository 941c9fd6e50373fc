// How a viewing ray takes a step (physics/step_*.glsl): the variant's integrator, leapfrog unless another is asked for.
#include "physics/ray.glsl"
#include "physics/step_euler.glsl"
#include "physics/step_leapfrog.glsl"
#include "physics/step_rk4.glsl"
#include "physics/step_sharma.glsl"

#if defined(INTEGRATOR_EULER)
const uint kEvaluationsPerStep = 1u;

RayStep stepRay(Ray ray, float perW, float ds) {
    return stepEuler(ray, ds);
}
#elif defined(INTEGRATOR_RK4)
const uint kEvaluationsPerStep = 4u;

RayStep stepRay(Ray ray, float perW, float ds) {
    return stepRk4(ray, ds);
}
#elif defined(INTEGRATOR_SHARMA)
const uint kEvaluationsPerStep = 3u;

RayStep stepRay(Ray ray, float perW, float ds) {
    return stepSharma(ray, ds);
}
#else
#define INTEGRATOR_LEAPFROG
const uint kEvaluationsPerStep = 1u;

RayStep stepRay(Ray ray, float perW, float ds) {
    return stepLeapfrogOnward(ray, perW, ds);
}
#endif

// Where the two straight pieces meet that stand for a step from `start`, for what lies along it.
vec3 middleOf(Ray start, RayStep taken) {
#ifdef INTEGRATOR_EULER
    return 0.5 * (start.x + taken.ray.x);
#else
    return taken.looked.x;
#endif
}

float meanIndex(RayStep taken, float ds) {
#ifdef INTEGRATOR_LEAPFROG
    return taken.n;
#else
    return taken.opticalLength / ds;
#endif
}

// Arc length of a step from x where no face is near: `stepLength` counts the domain's voxels, which are not the finest about
// objects with lattices of their own.
float usualStepAt(vec3 x) {
    return view.stepLength * finestVoxelAbout(x);
}
