#include "viewer/staged_pipeline.h"

#include <tuple>

namespace eikonal::viewer {

namespace {

std::optional<Reflections> reflectionsFor(const gpu::Context& context, const std::vector<std::string>& defines,
                                          const std::optional<ReflectionRules>& rules, std::size_t rays) {
    if (!rules) return std::nullopt;
    return Reflections(context, defines, *rules, rays);
}

std::vector<std::string> withReflections(std::vector<std::string> defines, const std::optional<ReflectionRules>& rules) {
    if (!rules) return defines;
    for (const std::string& define : Reflections::defines()) defines.push_back(define);
    return defines;
}

Generate::Source sourceOf(bool hasLens) { return hasLens ? Generate::Source::kLens : Generate::Source::kPinhole; }

} // namespace

StagedPipeline::StagedPipeline(const gpu::Context& context, std::vector<std::string> defines, const MarchSettings& settings,
                               const Lattice& lattice, bool hasLens, const std::optional<ReflectionRules>& rules,
                               std::size_t rays)
    : context_(context), defines_(withReflections(std::move(defines), rules)), settings_(settings), lattice_(lattice),
      reflections_(reflectionsFor(context, defines_, rules, rays)), generate_(context, defines_, sourceOf(hasLens)),
      steps_(settings.stepVoxels, settings.matterVoxels), shade_(context, defines_), accumulate_(context, defines_),
      count_(context, defines_) {}

March& StagedPipeline::march() {
    auto found = marches_.find(steps_);
    if (found == marches_.end()) {
        MarchSettings settings = settings_;
        std::tie(settings.stepVoxels, settings.matterVoxels) = steps_;
        found = marches_.emplace(steps_, March(context_, defines_, settings, lattice_)).first;
    }
    return found->second;
}

void StagedPipeline::configure(gpu::ViewBlock& view) {
    if (reflections_) reflections_->configure(view);
    march().configure(view);
}

void StagedPipeline::setLens(bool hasLens) { generate_ = Generate(context_, defines_, sourceOf(hasLens)); }

void StagedPipeline::setInsets(const InsetBounds& insets) {
    settings_.insets = insets;
    for (auto& [steps, march] : marches_) march.setInsets(insets);
}

void StagedPipeline::bind() const {
    if (reflections_) reflections_->bind();
}

void StagedPipeline::run(RayBatch& batch, const std::function<void(std::string_view)>& mark) {
    mark("generate");
    generate_.run(batch);
    mark("march");
    march().run(batch);
    if (reflections_) {
        mark("reflections");
        reflections_->run(batch, march(), shade_);
    }
    mark("shade");
    shade_.run(batch);
    mark("accumulate");
    accumulate_.run(batch);
    count_.run(batch);
}

} // namespace eikonal::viewer
