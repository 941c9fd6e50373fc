#include "viewer/fused_pipeline.h"

#include <algorithm>

#include "viewer/slices.h"
#include "viewer/view.h"

namespace eikonal::viewer {

namespace {

constexpr const char* kKernel = "viewer/draw_freely.comp.glsl";

std::vector<std::string> withSteps(std::vector<std::string> defines, const MarchSettings& settings) {
    for (const std::string& define : stepDefines(settings)) defines.push_back(define);
    return defines;
}

gpu::Kernel firstSlice(const gpu::Context& context, std::vector<std::string> defines, bool hasLens, gpu::uint blocksInTurn) {
    defines.push_back("BEGIN_RAYS");
    defines.push_back("BLOCKS_IN_TURN " + std::to_string(blocksInTurn));
    if (hasLens) defines.push_back("LENS");
    return {context, kKernel, defines};
}

} // namespace

bool FusedPipeline::serves(const std::vector<std::string>& defines, Integrator integrator) {
    const bool disperses = std::find(defines.begin(), defines.end(), "EFFECT_DISPERSION") != defines.end();
    return stepsFreely(defines, integrator) && !disperses;
}

FusedPipeline::FusedPipeline(const gpu::Context& context, std::vector<std::string> defines, const MarchSettings& settings,
                             const Lattice& lattice, bool hasLens)
    : context_(context), defines_(withSteps(std::move(defines), settings)), settings_(settings), lattice_(lattice),
      blocksInTurn_(portionsFor(context.limits()).blocksInTurn),
      first_(firstSlice(context, defines_, hasLens, blocksInTurn_)), onward_(context, kKernel, defines_) {
    limits();  // refuses a step that is not positive
}

void FusedPipeline::setStep(double stepVoxels, double matterVoxels) {
    settings_.stepVoxels = stepVoxels;
    settings_.matterVoxels = matterVoxels;
}

void FusedPipeline::setLens(bool hasLens) { first_ = firstSlice(context_, defines_, hasLens, blocksInTurn_); }

void FusedPipeline::run(RayBatch& batch, const std::function<void(std::string_view)>& mark) {
    mark("draw");
    batch.lists.clearFilled();
    runSlices(batch.lists, limits().mostSlices(), [&](std::uint32_t slice) {
        if (slice == 0) {
            first_.dispatch({(placesOfBlocks(batch.view.tileSize) + blocksInTurn_ - 1) / blocksInTurn_, 1, 1});
        } else {
            batch.lists.swap();
            batch.lists.dispatch(onward_);
        }
    });
}

std::optional<std::size_t> FusedPipeline::instructions() {
    const auto first = first_.instructions(), onward = onward_.instructions();
    return first && onward ? std::optional(*first + *onward) : std::nullopt;
}

} // namespace eikonal::viewer
