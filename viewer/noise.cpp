#include "viewer/noise.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "viewer/sampling.h"

namespace eikonal::viewer {

namespace {

double luminanceOf(const glm::vec3& radiance) {
    return 0.2126 * double(radiance.r) + 0.7152 * double(radiance.g) + 0.0722 * double(radiance.b);
}

} // namespace

double FilmNoise::relative() const {
    if (squaredError == 0.0) return 0.0;
    if (luminance == 0.0) return std::numeric_limits<double>::infinity();
    return std::sqrt(squaredError * pixels) / luminance;
}

FilmNoise& FilmNoise::operator+=(const FilmNoise& other) {
    squaredError += other.squaredError;
    luminance += other.luminance;
    pixels += other.pixels;
    return *this;
}

/// With samples of variance v the means of halves of a and b samples differ with variance v (1/a + 1/b), and that of all with
/// v/(a + b): a b/(a + b)^2 of it.
FilmNoise noiseOf(std::span<const gpu::FilmPixel> film, int samples) {
    const double inHalf = samplesInHalf(samples), others = samples - inHalf;
    FilmNoise noise{.pixels = double(film.size())};
    for (const gpu::FilmPixel& pixel : film) noise.luminance += luminanceOf(pixel.radiance);
    if (samples < 2) {
        noise.squaredError = std::numeric_limits<double>::infinity();
        return noise;
    }
    for (const gpu::FilmPixel& pixel : film) {
        const double half = double(pixel.halfLuminance);
        const double other = (samples * luminanceOf(pixel.radiance) - inHalf * half) / others;
        noise.squaredError += (half - other) * (half - other) * inHalf * others / (double(samples) * samples);
    }
    return noise;
}

bool isNoiseLookedAt(int samples) {
    return samples >= 4 && samples % std::max(2, int(std::bit_floor(unsigned(samples))) / 8) == 0;
}

} // namespace eikonal::viewer
