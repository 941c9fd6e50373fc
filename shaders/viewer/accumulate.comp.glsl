// Adds a sample of every pixel to the film. Everything but radiance is taken from the first ray, through the pixel's centre, at
// the reference wavelength.
#include "viewer/ray_states.glsl"

layout(local_size_x = kRaysPerGroup) in;

layout(std430, binding = kStorageFilm) buffer Film { FilmPixel film[]; };

// What a ray adds to its pixel. One that has met dispersion adds it band by band.
vec3 colourOf(RayState ray) {
#ifdef EFFECT_DISPERSION
    if (!isReferencePass()) {
        return bandToRgb * ray.radiance[bandChannel];
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

void develop(uint index, RayState ray) {
    FilmPixel pixel = film[filmStart + index];
    if (roundIndex == 0u && isReferencePass()) {
        pixel.radiance = vec3(0.0);
        pixel.halfLuminance = 0.0;
        pixel.exitDirection = unitDirection(ray);
        pixel.steps = ray.evaluations > 0u ? float(ray.evaluations - 1u + ray.lookUps) : 0.0;
        pixel.depth = ray.depth;
        pixel.entryDistance = ray.entryDistance;
        pixel.throughput = rayThroughput(ray);
        pixel.opticalLength = ray.opticalLength;
        pixel.normal = ray.crossingNormal;
    }
    // The reference pass begins a sample: it takes the new sample's share out of the mean of those before.
    bool begins = isReferencePass();
    vec3 colour = colourOf(ray);
    pixel.radiance += sampleWeight * (colour - (begins ? pixel.radiance : vec3(0.0)));
    pixel.halfLuminance += halfWeight * (luminance(colour) - (begins ? pixel.halfLuminance : 0.0));
    film[filmStart + index] = pixel;
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index < rayCount && isFollowed(rays[index])) {
        develop(index, rays[index]);
    }
}
