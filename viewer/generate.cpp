#include "viewer/generate.h"

namespace eikonal::viewer {

namespace {

std::vector<std::string> withSource(std::vector<std::string> defines, Generate::Source source) {
    if (source == Generate::Source::kGiven) defines.push_back("RAYS_GIVEN");
    if (source == Generate::Source::kLens) defines.push_back("LENS");
    return defines;
}

/// Those of all pieces of a picture, of one length (shaders/viewer/picture_order.glsl).
glm::uvec3 groupsOfPicture(glm::ivec2 size) {
    const auto over = [](int all, int each) { return (all + each - 1) / each; };
    const int blocks = over(size.x, gpu::kBlockEdge) * over(size.y, gpu::kBlockEdge);
    return {gpu::kPicturePieces * over(blocks, gpu::kPicturePieces), 1, 1};
}

} // namespace

Generate::Generate(const gpu::Context& context, std::vector<std::string> defines, Source source)
    : source_(source), kernel_(context, "viewer/generate.comp.glsl", withSource(std::move(defines), source)) {}

void Generate::run(RayBatch& batch) const {
    const glm::uvec3 groups = source_ == Source::kGiven ? batch.groups() : groupsOfPicture(batch.view.tileSize);
    batch.lists.fillByGroups(groups.x);
    kernel_.dispatch(groups);
}

} // namespace eikonal::viewer
