// What matter adds to a viewing ray and takes from it over a straight piece (docs/physics.md, sections 4 and 5):
// d(L/n^2)/ds = -sigma_t L/n^2 + (sigma_s p E + L_e)/n^2, exact for constants over the piece.
#include "physics/attenuation.glsl"
#include "physics/phase.glsl"
#include "viewer/light.glsl"

#if defined(EFFECT_ABSORPTION) || defined(EFFECT_SCATTERING) || defined(EFFECT_EMISSION)
#define MATTER
#endif

#if defined(EFFECT_EMISSION) || (defined(EFFECT_SCATTERING) && defined(BAKED_LIGHT))
#define GLOWS
#endif

#ifdef MATTER

#ifdef EFFECT_SCATTERING
// Radiance scattered into the ray per scene unit.
vec3 scatteredRadiance(vec3 x, vec3 direction, vec4 sigmaS) {
#ifdef BAKED_LIGHT
    if (max(sigmaS.r, max(sigmaS.g, sigmaS.b)) > 0.0) {
        return sigmaS.rgb * phasedIrradiance(x, direction, sampleAnisotropy(x, sigmaS));
    }
#endif
    return vec3(0.0);
}
#endif

// A piece of length ds around x: no longer than a voxel or so, or of matter that is even.
void passMatter(inout RayState ray, vec3 x, vec3 direction, float n, float ds) {
    vec3 sigmaT = vec3(0.0);
    vec3 source = vec3(0.0);
    ray.matterSamples += 1u;
#ifdef EFFECT_ABSORPTION
    sigmaT += sampleSigmaA(x);
#endif
#ifdef EFFECT_SCATTERING
    vec4 sigmaS = sampleSigmaS(x);
    sigmaT += sigmaS.rgb;
    source += scatteredRadiance(x, direction, sigmaS);
#endif
#ifdef EFFECT_EMISSION
    source += sampleEmission(x);
#endif
    vec3 tau = sigmaT * ds;
    vec3 mean = meanTransmittance3(tau);
#ifdef GLOWS
    ray.radiance += rayThroughput(ray) * source * mean * (ds / (n * n));
#endif
    ray.depth += tau;
    ray.transmittance *= 1.0 - tau * mean;
}

#endif
