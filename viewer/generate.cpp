#include "viewer/generate.h"

#include "viewer/view.h"

namespace eikonal::viewer {

namespace {

std::vector<std::string> withSource(std::vector<std::string> defines, Generate::Source source) {
    if (source == Generate::Source::kGiven) defines.push_back("RAYS_GIVEN");
    if (source == Generate::Source::kLens) defines.push_back("LENS");
    return defines;
}

} // namespace

Generate::Generate(const gpu::Context& context, std::vector<std::string> defines, Source source)
    : source_(source), kernel_(context, "viewer/generate.comp.glsl", withSource(std::move(defines), source)) {}

void Generate::run(RayBatch& batch) const {
    const glm::uvec3 groups =
        source_ == Source::kGiven ? batch.groups() : glm::uvec3(placesOfBlocks(batch.view.tileSize), 1, 1);
    batch.lists.fillByGroups(groups.x);
    kernel_.dispatch(groups);
}

} // namespace eikonal::viewer
