// Adds a sample of every pixel to the film. Everything but radiance is taken from the first ray, through the pixel's centre, at
// the reference wavelength.
#include "viewer/ray_states.glsl"
#include "viewer/film_pixels.glsl"

layout(local_size_x = kRaysPerGroup) in;

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

void develop(uint pixel, RayState ray) {
    vec4 radiance = filmRow(filmTexels, pixel, kRadianceRow);
    vec4 throughput = filmRow(filmTexels, pixel, kThroughputRow);
    if (view.roundIndex == 0u && isReferencePass()) {
        radiance = vec4(vec3(0.0), ray.evaluations > 0u ? float(ray.evaluations - 1u + ray.lookUps) : 0.0);
        throughput = vec4(rayThroughput(ray), 0.0);
        storeFilmRow(pixel, kExitRow, vec4(unitDirection(ray), ray.entryDistance));
        storeFilmRow(pixel, kDepthRow, vec4(ray.depth, ray.opticalLength));
        storeFilmRow(pixel, kNormalRow, vec4(ray.crossingNormal, 0.0));
    }
    // The reference pass begins a sample: it takes the new sample's share out of the mean of those before.
    bool begins = isReferencePass();
    vec3 colour = colourOf(ray);
    radiance.rgb += view.sampleWeight * (colour - (begins ? radiance.rgb : vec3(0.0)));
    throughput.a += view.halfWeight * (luminance(colour) - (begins ? throughput.a : 0.0));
    storeFilmRow(pixel, kRadianceRow, radiance);
    storeFilmRow(pixel, kThroughputRow, throughput);
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    RayState ray = loadRay(min(index, view.rayCount - 1u));
    if (index < view.rayCount && isFollowed(ray)) {
        develop(view.filmStart + index, ray);
    }
}
