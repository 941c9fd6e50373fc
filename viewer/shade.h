#pragma once
// Third step: what each ray sees at its end, and its radiance at the camera.

#include "viewer/ray_batch.h"

namespace eikonal::viewer {

class Shade {
public:
    Shade(const gpu::Context& context, const std::vector<std::string>& defines);

    void run(const RayBatch& batch) const { kernel_.dispatch(batch.groups()); }

private:
    gpu::Kernel kernel_;
};

} // namespace eikonal::viewer
