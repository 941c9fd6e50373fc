#pragma once
// Fourth step: samples into the film.

#include "viewer/ray_batch.h"

namespace eikonal::viewer {

class Accumulate {
public:
    Accumulate(const gpu::Context& context, const std::vector<std::string>& defines);

    void run(const RayBatch& batch) const { kernel_.dispatch(batch.groups()); }

private:
    gpu::Kernel kernel_;
};

} // namespace eikonal::viewer
