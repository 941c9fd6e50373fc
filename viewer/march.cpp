#include "viewer/march.h"

#include "viewer/slices.h"

namespace eikonal::viewer {

namespace {

std::vector<std::string> withSteps(std::vector<std::string> defines, const MarchSettings& settings) {
    for (const std::string& define : stepDefines(settings)) defines.push_back(define);
    return defines;
}

} // namespace

March::March(const gpu::Context& context, const std::vector<std::string>& defines, const MarchSettings& settings,
             const Lattice& lattice)
    : limits_(context, defines, settings, lattice),
      onward_(context,
              stepsFreely(defines, settings.integrator) ? "viewer/march_freely.comp.glsl" : "viewer/march_on.comp.glsl",
              withSteps(defines, settings)) {
    if (!stepsFreely(defines, settings.integrator)) first_.emplace(context, "viewer/march.comp.glsl", withSteps(defines, settings));
}

std::optional<std::size_t> March::instructions() const {
    const auto onward = onward_.instructions();
    const auto first = first_ ? first_->instructions() : std::size_t(0);
    return onward && first ? std::optional(*onward + *first) : std::nullopt;
}

void March::run(RayBatch& batch) const {
    runSlices(batch.lists, mostSlices(), [&](std::uint32_t slice) { runSlice(batch, slice); });
}

void March::runSlice(RayBatch& batch, std::uint32_t slice) const {
    batch.lists.swap();
    batch.lists.dispatch(slice == 0 && first_ ? *first_ : onward_);
}

} // namespace eikonal::viewer
