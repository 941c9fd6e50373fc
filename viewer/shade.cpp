#include "viewer/shade.h"

namespace eikonal::viewer {

Shade::Shade(const gpu::Context& context, const std::vector<std::string>& defines)
    : kernel_(context, "viewer/shade.comp.glsl", defines) {}

} // namespace eikonal::viewer
