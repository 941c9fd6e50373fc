#include "viewer/count.h"

namespace eikonal::viewer {

Count::Count(const gpu::Context& context, const std::vector<std::string>& defines)
    : kernel_(context, "viewer/count.comp.glsl", defines) {}

void Count::run(const RayBatch& batch) const {
    constexpr gpu::uint kRaysOfAGroup = gpu::kRaysPerGroup * gpu::kRaysPerCount;
    kernel_.dispatch({(batch.view.rayCount + kRaysOfAGroup - 1) / kRaysOfAGroup, 1, 1});
}

} // namespace eikonal::viewer
