#pragma once
// What an image needs to know and the scene does not say.

#include <cstddef>
#include <cstdint>
#include <functional>

#include "viewer/view.h"

namespace eikonal {

/// Image size, samples, filter, exposure, tone curve and step come from the scene.
struct RenderOptions {
    /// Edges of what a pixel's samples cover, of its own; less than 1: the image is a sample of the pixels of a larger one.
    glm::vec2 pixelShare{1.0f};
    bool straightFlights = true;          ///< false: steps through everything, for comparison
    bool fused = true;                    ///< false: kernel after kernel also where one draws rays at once, for comparison
    std::uint32_t maxEvaluations = 0;     ///< of the index field and look-ups by ray; 0: from the domain's size
    std::uint32_t stepsPerSlice = 0;      ///< of a dispatch; 0: as many as the device likes
    std::size_t tileRays = 0;             ///< rays under way at a time: bounds the memory; 0: as the device likes it
    bool channels = true;                 ///< false: only what is displayed is read back
    double minThroughput = 1e-5;          ///< a ray of which less is left ends
    std::function<void(double)> progress; ///< called with the fraction done; may throw to stop
};

} // namespace eikonal
