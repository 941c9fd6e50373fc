#include "viewer/generate.h"

namespace eikonal::viewer {

namespace {

std::vector<std::string> withSource(std::vector<std::string> defines, Generate::Source source) {
    if (source == Generate::Source::kGiven) defines.push_back("RAYS_GIVEN");
    if (source == Generate::Source::kLens) defines.push_back("LENS");
    return defines;
}

} // namespace

Generate::Generate(const gpu::Context& context, std::vector<std::string> defines, Source source)
    : kernel_(context, "viewer/generate.comp.glsl", withSource(std::move(defines), source)) {}

void Generate::run(RayBatch& batch) const {
    batch.lists.clearFilled();
    kernel_.dispatch(batch.groups());
}

} // namespace eikonal::viewer
