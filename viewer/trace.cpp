#include "viewer/trace.h"

#include <algorithm>
#include <map>
#include <optional>

#include "common/accuracy.h"
#include "common/device_frame.h"
#include "common/gpu_fields.h"
#include "common/physics.h"
#include "common/spectral_fields.h"
#include "viewer/clearance.h"
#include "viewer/generate.h"
#include "viewer/march.h"
#include "viewer/reflections.h"

namespace eikonal {

namespace {

constexpr std::size_t kRaysAtATime = 1u << 16;

enum class Boundaries { kOnlyRefract, kReflect };

EffectSet tracedEffects(EffectSet effects, Boundaries boundaries) {
    for (EffectDecision& decision : effects.decisions) {
        decision.on = decision.on && (decision.effect == Effect::kRefraction || decision.effect == Effect::kDispersion ||
                                      decision.effect == Effect::kAbsorption || decision.effect == Effect::kOpaque ||
                                      (decision.effect == Effect::kReflection && boundaries == Boundaries::kReflect));
    }
    return effects;
}

/// Whatever the length of what is given.
glm::dvec3 directionOf(const TraceRay& ray) {
    const glm::dvec3 size = glm::abs(ray.direction);
    return glm::normalize(ray.direction / std::max({size.x, size.y, size.z}));
}

double wavelengthOf(const TraceRay& ray) { return ray.wavelengthMicrons.value_or(f64::kReferenceMicrons); }

std::optional<viewer::Clearance> clearanceFor(const gpu::Context& context, const Fields& fields,
                                              const EffectSet& effects, const Accuracy& accuracy,
                                              StraightFlights flights) {
    if (flights == StraightFlights::kNone) return std::nullopt;
    return viewer::Clearance(context, fields, effects, {.tolerance = accuracy.tolerance});
}

/// As the device takes a ray: from near the domain, for single precision, wherever it starts. A ray that misses it by much does
/// so by less.
gpu::GivenRay givenRay(const TraceRay& ray, const Lattice& lattice) {
    const glm::dvec3 direction = directionOf(ray);
    const double reach = glm::length(lattice.extent());
    const glm::dvec3 origin = deviceFromWorld(lattice, ray.origin);  // from the domain's middle
    const double toMiddle = -glm::dot(origin, direction);
    const glm::dvec3 beside = origin + toMiddle * direction;
    const double near = std::min(reach / std::max(glm::length(beside), reach), 1.0);
    const glm::dvec3 start = toMiddle > reach ? near * beside - reach * direction : origin;
    return {glm::vec3(start), 0.0f, glm::vec3(direction), 0.0f};
}

/// How rays are followed.
struct TraceRules {
    StraightFlights flights = StraightFlights::kTaken;
    Boundaries boundaries = Boundaries::kOnlyRefract;
    std::uint32_t stepsPerSlice = 0;  ///< 0: as many as the device likes
};

/// The kernels and buffers that rays are followed with, batch after batch.
struct Tracer {
    Lattice lattice;
    EffectSet effects;
    GpuFields fields;
    std::optional<viewer::Clearance> clearance;
    std::vector<std::string> defines;
    viewer::RayBatch batch;
    gpu::Buffer given;
    viewer::Generate generate;
    viewer::March march;

    Tracer(const gpu::Context& context, const Fields& sceneFields, const EffectSet& sceneEffects,
           const Accuracy& accuracy, const TraceRules& rules, std::size_t rayCount)
        : lattice(sceneFields.lattice), effects(tracedEffects(sceneEffects, rules.boundaries)),
          fields(context, sceneFields, effects, interpolationOfImages(accuracy)),
          clearance(clearanceFor(context, sceneFields, effects, accuracy, rules.flights)),
          defines(allDefines(rules.boundaries)), batch(context, std::min(rayCount, kRaysAtATime)),
          given(context, std::min(rayCount, kRaysAtATime) * sizeof(gpu::GivenRay), "given rays"),
          generate(context, fields.defines(), viewer::Generate::Source::kGiven),
          march(context, defines,
                {.stepVoxels = stepVoxelsOf(accuracy), .integrator = integratorOf(accuracy), .stepsPerSlice = rules.stepsPerSlice,
                 .insets = fields.insetBounds()},
                sceneFields.lattice) {
        march.configure(batch.view);
        batch.view.bandChannel = gpu::kAllChannels;
        if (clearance) clearance->configure(batch.view);
    }

    std::vector<std::string> allDefines(Boundaries boundaries) const {
        auto all = fields.defines();
        const auto add = [&](const std::vector<std::string>& more) { all.insert(all.end(), more.begin(), more.end()); };
        if (clearance) add(clearance->defines());
        if (boundaries == Boundaries::kReflect) add(viewer::Reflections::defines());
        return all;
    }

    /// Rays of one wavelength.
    void start(std::span<const TraceRay> rays) {
        fields.setWavelength(wavelengthOf(rays.front()));
        std::vector<gpu::GivenRay> rows(rays.size());
        std::transform(rays.begin(), rays.end(), rows.begin(), [this](const TraceRay& ray) { return givenRay(ray, lattice); });
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

TraceResult resultOf(const gpu::RayState& state, const TraceRay& ray, const Lattice& lattice) {
    if (state.status == gpu::kMissed) return {.position = ray.origin, .direction = ray.direction};
    TraceResult result;
    result.position = worldFromDevice(lattice, glm::dvec3(state.x));
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
    for (std::size_t i = 0; i < rays.size(); ++i) paths[i].push_back(resultOf(before[i], rays[i], tracer.lattice));
    const auto underWay = [](const gpu::RayState& state) { return state.status == gpu::kMarching; };
    for (std::uint32_t slice = 0; std::any_of(before.begin(), before.end(), underWay); ++slice) {
        tracer.march.runSlice(tracer.batch, slice);
        auto after = tracer.states();
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const bool moved = after[i].pathLength > before[i].pathLength || after[i].status != before[i].status;
            if (moved) paths[i].push_back(resultOf(after[i], rays[i], tracer.lattice));
        }
        before = std::move(after);
    }
    return paths;
}

std::vector<TraceReflection> roundResults(const Batch& batch, const std::vector<gpu::RayState>& states,
                                          const Lattice& lattice) {
    std::vector<TraceReflection> results;
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (states[i].status == gpu::kNoRay) continue;
        results.push_back({batch.rows[i], int(states[i].generation), 0.5 * (states[i].throughputS + states[i].throughputP),
                           resultOf(states[i], batch.rays[i], lattice)});
    }
    return results;
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
    Tracer tracer(context, fields, effects, accuracy, {.flights = flights}, rays.size());
    std::vector<TraceResult> results(rays.size());
    for (const Batch& batch : batchesOf(rays, effects.has(Effect::kDispersion))) {
        tracer.start(batch.rays);
        tracer.march.run(tracer.batch);
        const auto states = tracer.states();
        for (std::size_t i = 0; i < states.size(); ++i) results[batch.rows[i]] = resultOf(states[i], batch.rays[i], tracer.lattice);
    }
    context.throwIfError();
    return results;
}

std::vector<TracePoint> tracePaths(const gpu::Context& context, const Fields& fields, const EffectSet& effects,
                                   const Accuracy& accuracy, const std::vector<TraceRay>& rays) {
    requireIndex(fields, effects, rays);
    Tracer tracer(context, fields, effects, accuracy, {.stepsPerSlice = 1}, rays.size());
    std::vector<std::vector<TraceResult>> paths(rays.size());
    for (const Batch& batch : batchesOf(rays, effects.has(Effect::kDispersion))) {
        auto some = batchPaths(tracer, batch.rays);
        for (std::size_t i = 0; i < some.size(); ++i) paths[batch.rows[i]] = std::move(some[i]);
    }
    std::vector<TracePoint> points;
    for (std::size_t row = 0; row < paths.size(); ++row) {
        for (const TraceResult& at : paths[row]) {
            points.push_back({row, at});
            points.back().at.status = paths[row].back().status;
        }
    }
    context.throwIfError();
    return points;
}

std::vector<TraceReflection> traceReflections(const gpu::Context& context, const Fields& fields, const EffectSet& effects,
                                              const Accuracy& accuracy, const std::vector<TraceRay>& rays) {
    requireIndex(fields, effects, rays);
    if (rays.empty() || accuracy.reflections == 0 || !effects.has(Effect::kReflection)) return {};
    Tracer tracer(context, fields, effects, accuracy, {.boundaries = Boundaries::kReflect}, rays.size());
    viewer::Reflections reflections(context, tracer.fields.defines(), {accuracy.reflections, accuracy.tolerance},
                                    std::min(rays.size(), kRaysAtATime));
    reflections.configure(tracer.batch.view);
    std::vector<TraceReflection> results;
    for (const Batch& batch : batchesOf(rays, effects.has(Effect::kDispersion))) {
        reflections.bind();
        tracer.start(batch.rays);
        tracer.march.run(tracer.batch);
        while (reflections.marchRound(tracer.batch, tracer.march)) {
            const auto round = roundResults(batch, reflections.states(tracer.batch), tracer.lattice);
            results.insert(results.end(), round.begin(), round.end());
        }
    }
    std::stable_sort(results.begin(), results.end(), [](const auto& a, const auto& b) { return a.ray < b.ray; });
    context.throwIfError();
    return results;
}

} // namespace eikonal
