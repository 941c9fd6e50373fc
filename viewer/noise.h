#pragma once
// The noise of a film, from two halves of its samples that differ by nothing but chance.

#include <cmath>
#include <span>

#include "shaders/shared/view_blocks.h"

namespace eikonal::viewer {

/// Sums over pixels, which add up over the parts of a picture.
struct FilmNoise {
    double squaredError = 0.0;  ///< of luminance: the variance of the pixels' means
    double luminance = 0.0;
    double pixels = 0.0;

    /// Relative standard error: the root mean square over pixels of the standard error of luminance, over the mean luminance.
    /// 0 where all is black, infinite where nothing is known.
    double relative() const;
    FilmNoise& operator+=(const FilmNoise& other);
};

/// Of a film of so many samples a pixel; one alone tells nothing.
FilmNoise noiseOf(std::span<const gpu::FilmPixel> film, int samples);

/// Whether noise is looked at after so many samples: from 4 on, ever rarer, but at least after every eighth part more.
bool isNoiseLookedAt(int samples);

} // namespace eikonal::viewer
