#include "viewer/reflections.h"

#include "shaders/shared/reflection_blocks.h"

namespace eikonal::viewer {

namespace {

// What is too weak to follow is seen in the environment instead: that much of its difference from what is there.
constexpr double kLeastOverTolerance = 0.05;

} // namespace

Reflections::Reflections(const gpu::Context& context, const std::vector<std::string>& defines,
                         const ReflectionRules& rules, std::size_t capacity)
    : rules_(rules), kernel_(context, "viewer/reflect.comp.glsl", defines),
      rays_(context, capacity * sizeof(gpu::RayState), "rays of reflections"),
      waiting_(context, capacity * sizeof(gpu::PixelReflections), "waiting reflections") {
    waiting_.fill(0);
    rays_.fill(gpu::kNoRay);
}

bool Reflections::areNeeded(const EffectSet& effects, int generations) {
    const bool surfaces = effects.has(Effect::kTint) || effects.has(Effect::kRoughness);
    return effects.has(Effect::kReflection) && (generations > 0 || surfaces);
}

void Reflections::configure(gpu::ViewBlock& view) const {
    view.mostGenerations = gpu::uint(rules_.generations);
    view.leastReflected = float(kLeastOverTolerance * rules_.tolerance);
}

void Reflections::bind() const { waiting_.bindStorage(gpu::kStorageReflections); }

bool Reflections::marchRound(RayBatch& batch, const March& march) {
    batch.rays.bindStorage(gpu::kStorageDirectRays);
    RayBatch::bindRays(rays_);
    batch.lists.clearFilled();
    kernel_.dispatch(batch.groups());
    const std::uint32_t started = batch.lists.filledCount();
    count_ += started;
    if (started > 0) march.run(batch);
    RayBatch::bindRays(batch.rays);
    return started > 0;
}

void Reflections::run(RayBatch& batch, const March& march, const Shade& shade) {
    while (marchRound(batch, march)) {
        RayBatch::bindRays(rays_);
        shade.run(batch);
    }
    RayBatch::bindRays(batch.rays);
}

std::vector<gpu::RayState> Reflections::states(const RayBatch& batch) const {
    return rays_.download<gpu::RayState>(batch.view.rayCount);
}

} // namespace eikonal::viewer
