#pragma once
// The samples of a pixel: where they lie within its filter and on the lens, and how they weigh in the film.

#include "common/scene.h"
#include "shaders/shared/view_blocks.h"

namespace eikonal::viewer {

/// An image is made in rounds of one ray a pixel. Round 0 goes through the pixel's centre and the middle of the lens: it is the
/// first sample of a pinhole, while a lens has it as a sharp picture that its first sample, round 1, replaces.
struct Sampling {
    PixelFilter filter = PixelFilter::kBox;
    double filterWidth = 1.0;  ///< from edge to edge [pixels]
    double lensRadius = 0.0;   ///< [scene units]; 0: a pinhole

    bool hasLens() const { return lensRadius > 0.0; }
    /// Rounds that so many samples take.
    int roundsOf(int samples) const { return hasLens() ? samples + 1 : samples; }
    /// Samples whose mean the film is after so many rounds.
    int samplesIn(int rounds) const { return hasLens() && rounds > 1 ? rounds - 1 : rounds; }
};

Sampling samplingOf(const RenderSettings& settings, const Camera& camera);

/// Sets which sample of each pixel is next, where it lies, and its weight in the means of those so far.
void configureRound(gpu::ViewBlock& view, int round, const Sampling& sampling);

/// Index of the sample that a round takes, counted from 0.
int sampleOfRound(int round, const Sampling& sampling);

/// Position of a sample within its pixel, 0 to 1 and beyond where the filter is wider: the R2 low-discrepancy sequence, spread
/// by the filter. Sample 0 is the centre. The same in all pixels, so that edges come out even.
glm::vec2 subPixelPosition(int sample, PixelFilter filter, double width);

/// Whether a sample belongs to the half by which the film tells its noise: that in which the sample's bits have an even sum.
/// This Thue-Morse sequence takes one of every two samples, and beats with no low-discrepancy sequence.
bool isInHalf(int sample);

/// How many of the first samples are in that half.
int samplesInHalf(int samples);

} // namespace eikonal::viewer
