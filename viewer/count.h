#pragma once
// What the rays of a tile have cost, into the statistics.

#include "viewer/ray_batch.h"

namespace eikonal::viewer {

class Count {
public:
    Count(const gpu::Context& context, const std::vector<std::string>& defines);

    void run(const RayBatch& batch) const;

private:
    gpu::Kernel kernel_;
};

} // namespace eikonal::viewer
