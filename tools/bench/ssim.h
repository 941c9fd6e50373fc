#pragma once
// How different two images look: structural similarity.
// Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli, Image Quality Assessment: From Error Visibility to Structural
// Similarity, IEEE Transactions on Image Processing 13(4), 2004.

#include <vector>

namespace eikonal::bench {

/// Values 0 to 1, as encoded for a display, row after row.
struct GreyImage {
    int width = 0, height = 0;
    std::vector<double> values;
};

/// 1 - mean SSIM over all windows of 11 × 11 pixels (Gaussian weights, σ = 1.5 pixels) that lie within images of equal size:
/// 0 for equal images, about 0.01 where a difference begins to be seen. At least 11 pixels along each edge.
double structuralDissimilarity(const GreyImage& a, const GreyImage& b);

} // namespace eikonal::bench
