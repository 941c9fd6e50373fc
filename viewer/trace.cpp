#include "viewer/trace.h"

#include <algorithm>
#include <optional>

#include "common/accuracy.h"
#include "common/gpu_fields.h"
#include "viewer/clearance.h"
#include "viewer/generate.h"
#include "viewer/march.h"

namespace eikonal {

namespace {

constexpr std::size_t kRaysAtATime = 1u << 16;

EffectSet tracedEffects(EffectSet effects) {
    for (EffectDecision& decision : effects.decisions) {
        decision.on = decision.on && (decision.effect == Effect::kRefraction || decision.effect == Effect::kAbsorption ||
                                      decision.effect == Effect::kOpaque);
    }
    return effects;
}

std::optional<viewer::Clearance> clearanceFor(const gpu::Context& context, const Fields& fields,
                                              const EffectSet& effects, const Accuracy& accuracy,
                                              StraightFlights flights) {
    if (flights == StraightFlights::kNone) return std::nullopt;
    return viewer::Clearance(context, fields, tracedEffects(effects), {.tolerance = accuracy.tolerance});
}

/// The kernels and buffers that rays are followed with, batch after batch.
struct Tracer {
    GpuFields fields;
    std::optional<viewer::Clearance> clearance;
    std::vector<std::string> defines;
    viewer::RayBatch batch;
    gpu::Buffer given;
    viewer::Generate generate;
    viewer::March march;

    Tracer(const gpu::Context& context, const Fields& sceneFields, const EffectSet& effects,
           const Accuracy& accuracy, StraightFlights flights, std::uint32_t stepsPerSlice, std::size_t capacity)
        : fields(context, sceneFields, tracedEffects(effects)),
          clearance(clearanceFor(context, sceneFields, effects, accuracy, flights)),
          defines(allDefines()), batch(context, capacity),
          given(context, capacity * sizeof(gpu::GivenRay), "given rays"),
          generate(context, fields.defines(), viewer::Generate::Source::kGiven),
          march(context, defines, {.stepVoxels = stepVoxelsOf(accuracy), .stepsPerSlice = stepsPerSlice},
                sceneFields.lattice) {
        march.configure(batch.view);
        if (clearance) clearance->configure(batch.view);
    }

    std::vector<std::string> allDefines() const {
        auto all = fields.defines();
        if (clearance) {
            for (const std::string& define : clearance->defines()) all.push_back(define);
        }
        return all;
    }

    void start(std::span<const TraceRay> rays) {
        std::vector<gpu::GivenRay> rows(rays.size());
        std::transform(rays.begin(), rays.end(), rows.begin(), [](const TraceRay& ray) {
            return gpu::GivenRay{glm::vec3(ray.origin), 0.0f, glm::vec3(glm::normalize(ray.direction)), 0.0f};
        });
        given.upload(std::span<const gpu::GivenRay>(rows));
        batch.view.rayCount = gpu::uint(rays.size());
        batch.bind();
        given.bindStorage(gpu::kStorageGiven);
        fields.bind();
        if (clearance) clearance->bind();
        generate.run(batch);
    }

    std::vector<gpu::RayState> states() const { return batch.rays.download<gpu::RayState>(batch.view.rayCount); }
};

TraceStatus statusOf(gpu::uint status) {
    switch (status) {
        case gpu::kHitOpaque: return TraceStatus::kAbsorbed;
        case gpu::kStepLimit: return TraceStatus::kLimit;
        case gpu::kMissed: return TraceStatus::kMissed;
        default: return TraceStatus::kExited;
    }
}

TraceResult resultOf(const gpu::RayState& state, const TraceRay& ray) {
    if (state.status == gpu::kMissed) return {.position = ray.origin, .direction = ray.direction};
    TraceResult result;
    result.position = glm::dvec3(state.x);
    result.direction = glm::normalize(glm::dvec3(state.w));
    result.opticalLength = state.opticalLength;
    result.length = state.pathLength;
    result.depth = glm::dvec3(state.depth);
    result.evaluations = state.evaluations;
    result.status = statusOf(state.status);
    return result;
}

std::vector<std::span<const TraceRay>> batchesOf(const std::vector<TraceRay>& rays) {
    std::vector<std::span<const TraceRay>> batches;
    for (std::size_t first = 0; first < rays.size(); first += kRaysAtATime) {
        batches.push_back(std::span(rays).subspan(first, std::min(kRaysAtATime, rays.size() - first)));
    }
    return batches;
}

/// Paths of one batch: slices of one step, read back after each.
std::vector<std::vector<TraceResult>> batchPaths(Tracer& tracer, std::span<const TraceRay> rays) {
    tracer.start(rays);
    auto before = tracer.states();
    std::vector<std::vector<TraceResult>> paths(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) paths[i].push_back(resultOf(before[i], rays[i]));
    const auto underWay = [](const gpu::RayState& state) { return state.status == gpu::kMarching; };
    for (std::uint32_t slice = 0; std::any_of(before.begin(), before.end(), underWay); ++slice) {
        const bool more = tracer.march.runSlice(tracer.batch, slice);
        auto after = tracer.states();
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (underWay(before[i])) paths[i].push_back(resultOf(after[i], rays[i]));
        }
        before = std::move(after);
        if (!more) break;
    }
    return paths;
}

} // namespace

std::string_view traceStatusName(TraceStatus status) {
    switch (status) {
        case TraceStatus::kExited: return "exited";
        case TraceStatus::kAbsorbed: return "absorbed";
        case TraceStatus::kLimit: return "limit";
        case TraceStatus::kMissed: break;
    }
    return "missed";
}

std::vector<TraceResult> traceRays(const gpu::Context& context, const Fields& fields, const EffectSet& effects,
                                   const Accuracy& accuracy, const std::vector<TraceRay>& rays,
                                   StraightFlights flights) {
    Tracer tracer(context, fields, effects, accuracy, flights, 0, std::min(rays.size(), kRaysAtATime));
    std::vector<TraceResult> results;
    results.reserve(rays.size());
    for (const auto batch : batchesOf(rays)) {
        tracer.start(batch);
        tracer.march.run(tracer.batch);
        const auto states = tracer.states();
        for (std::size_t i = 0; i < states.size(); ++i) results.push_back(resultOf(states[i], batch[i]));
    }
    context.throwIfError();
    return results;
}

std::vector<TracePoint> tracePaths(const gpu::Context& context, const Fields& fields, const EffectSet& effects,
                                   const Accuracy& accuracy, const std::vector<TraceRay>& rays) {
    Tracer tracer(context, fields, effects, accuracy, StraightFlights::kTaken, 1, std::min(rays.size(), kRaysAtATime));
    std::vector<TracePoint> points;
    std::size_t row = 0;
    for (const auto batch : batchesOf(rays)) {
        for (const auto& path : batchPaths(tracer, batch)) {
            for (const TraceResult& at : path) points.push_back({row, at});
            ++row;
        }
    }
    context.throwIfError();
    return points;
}

} // namespace eikonal
