#include "viewer/accumulate.h"

namespace eikonal::viewer {

Accumulate::Accumulate(const gpu::Context& context, const std::vector<std::string>& defines)
    : kernel_(context, "viewer/accumulate.comp.glsl", defines) {}

} // namespace eikonal::viewer
