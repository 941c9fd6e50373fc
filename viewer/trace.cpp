#include "viewer/trace.h"

#include <algorithm>
#include <map>
#include <optional>

#include "common/accuracy.h"
#include "common/gpu_fields.h"
#include "common/physics.h"
#include "common/spectral_fields.h"
#include "viewer/clearance.h"
#include "viewer/generate.h"
#include "viewer/march.h"

namespace eikonal {

namespace {

constexpr std::size_t kRaysAtATime = 1u << 16;

EffectSet tracedEffects(EffectSet effects) {
    for (EffectDecision& decision : effects.decisions) {
        decision.on = decision.on && (decision.effect == Effect::kRefraction || decision.effect == Effect::kDispersion ||
                                      decision.effect == Effect::kAbsorption || decision.effect == Effect::kOpaque);
    }
    return effects;
}

double wavelengthOf(const TraceRay& ray) { return ray.wavelengthMicrons.value_or(f64::kReferenceMicrons); }

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
          march(context, defines,
                {.stepVoxels = stepVoxelsOf(accuracy), .integrator = integratorOf(accuracy), .stepsPerSlice = stepsPerSlice},
                sceneFields.lattice) {
        march.configure(batch.view);
        batch.view.bandChannel = gpu::kAllChannels;
        if (clearance) clearance->configure(batch.view);
    }

    std::vector<std::string> allDefines() const {
        auto all = fields.defines();
        if (clearance) {
            for (const std::string& define : clearance->defines()) all.push_back(define);
        }
        return all;
    }

    /// Rays of one wavelength.
    void start(std::span<const TraceRay> rays) {
        fields.setWavelength(wavelengthOf(rays.front()));
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

/// The rays of an input that are followed together: of one wavelength, at most kRaysAtATime.
struct Batch {
    std::vector<std::size_t> rows;
    std::vector<TraceRay> rays;
};

std::vector<Batch> batchesOf(const std::vector<TraceRay>& rays, bool byWavelength) {
    std::map<double, std::vector<std::size_t>> rowsOfWavelength;
    for (std::size_t row = 0; row < rays.size(); ++row) {
        rowsOfWavelength[byWavelength ? wavelengthOf(rays[row]) : f64::kReferenceMicrons].push_back(row);
    }
    std::vector<Batch> batches;
    for (const auto& [wavelength, rows] : rowsOfWavelength) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (i % kRaysAtATime == 0) batches.emplace_back();
            batches.back().rows.push_back(rows[i]);
            batches.back().rays.push_back(rays[rows[i]]);
        }
    }
    return batches;
}

/// The longest wavelength is the one that dispersing matter refracts least.
void requireIndex(const Fields& fields, const EffectSet& effects, const std::vector<TraceRay>& rays) {
    if (!effects.has(Effect::kDispersion)) return;
    double longest = f64::kReferenceMicrons;
    for (const TraceRay& ray : rays) longest = std::max(longest, wavelengthOf(ray));
    requireIndexAt(fields, longest, "wavelength_nm");
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
    requireIndex(fields, effects, rays);
    Tracer tracer(context, fields, effects, accuracy, flights, 0, std::min(rays.size(), kRaysAtATime));
    std::vector<TraceResult> results(rays.size());
    for (const Batch& batch : batchesOf(rays, effects.has(Effect::kDispersion))) {
        tracer.start(batch.rays);
        tracer.march.run(tracer.batch);
        const auto states = tracer.states();
        for (std::size_t i = 0; i < states.size(); ++i) results[batch.rows[i]] = resultOf(states[i], batch.rays[i]);
    }
    context.throwIfError();
    return results;
}

std::vector<TracePoint> tracePaths(const gpu::Context& context, const Fields& fields, const EffectSet& effects,
                                   const Accuracy& accuracy, const std::vector<TraceRay>& rays) {
    requireIndex(fields, effects, rays);
    Tracer tracer(context, fields, effects, accuracy, StraightFlights::kTaken, 1, std::min(rays.size(), kRaysAtATime));
    std::vector<std::vector<TraceResult>> paths(rays.size());
    for (const Batch& batch : batchesOf(rays, effects.has(Effect::kDispersion))) {
        auto some = batchPaths(tracer, batch.rays);
        for (std::size_t i = 0; i < some.size(); ++i) paths[batch.rows[i]] = std::move(some[i]);
    }
    std::vector<TracePoint> points;
    for (std::size_t row = 0; row < paths.size(); ++row) {
        for (const TraceResult& at : paths[row]) points.push_back({row, at});
    }
    context.throwIfError();
    return points;
}

} // namespace eikonal
