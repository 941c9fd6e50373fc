#pragma once
// First step: camera rays, or rays that are given, at the places where they enter the domain.

#include <span>
#include <vector>

#include "viewer/ray_batch.h"

namespace eikonal::viewer {

class Generate {
public:
    enum class Source { kPinhole, kLens, kGiven };

    Generate(const gpu::Context& context, std::vector<std::string> defines, Source source);

    /// Fills the list with the rays that enter the domain.
    void run(RayBatch& batch) const;

private:
    Source source_;
    gpu::Kernel kernel_;
};

} // namespace eikonal::viewer
