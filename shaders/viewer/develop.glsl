// Adds a sample of a pixel to the film. Everything but radiance is taken from the first ray, through the pixel's centre, at the
// reference wavelength.
#include "viewer/ray_states.glsl"
#include "viewer/film_pixels.glsl"

layout(std430, binding = kStorageFilm) writeonly buffer Film { vec4 filmRows[]; };

// What a ray adds to its pixel. One that has met dispersion adds it band by band.
vec3 colourOf(RayState ray) {
#ifdef EFFECT_DISPERSION
    if (!isReferencePass()) {
        return view.bandToRgb * ray.radiance[view.bandChannel];
    }
    return ray.dispersed != 0u ? vec3(0.0) : ray.radiance;
#else
    return ray.radiance;
#endif
}

// Of linear Rec.709.
float luminance(vec3 colour) {
    return dot(colour, vec3(0.2126, 0.7152, 0.0722));
}

void storeFilmRow(uint pixel, int row, vec4 values) {
    filmRows[kRowsPerPixel * int(pixel) + row] = values;
}

// What only the first ray tells.
void developFirst(uint pixel, RayState ray) {
    float steps = ray.evaluations > 0u ? float(ray.evaluations - 1u + ray.lookUps) : 0.0;
    storeFilmRow(pixel, kExitRow, vec4(unitDirection(ray), ray.entryDistance));
    storeFilmRow(pixel, kDepthRow, vec4(ray.depth, ray.opticalLength));
    storeFilmRow(pixel, kThroughputRow, vec4(rayThroughput(ray), steps));
    storeFilmRow(pixel, kNormalRow, vec4(ray.crossingNormal, 0.0));
}

// Radiance, and luminance of the half that the sample is in.
void develop(uint pixel, RayState ray) {
    vec4 means = filmRow(filmTexels, pixel, kRadianceRow);
    if (view.roundIndex == 0u && isReferencePass()) {
        means = vec4(0.0);
        developFirst(pixel, ray);
    }
    // The reference pass begins a sample: it takes the new sample's share out of the mean of those before.
    vec3 colour = colourOf(ray);
    vec4 before = isReferencePass() ? means : vec4(0.0);
    means.rgb += view.sampleWeight * (colour - before.rgb);
    means.a += view.halfWeight * (luminance(colour) - before.a);
    storeFilmRow(pixel, kRadianceRow, means);
}
