#include "tools/bench/effect_ladder.h"

#include <algorithm>

#include <fmt/format.h>

namespace eikonal::bench {

namespace {

/// Those that are on, refraction first: the others cost nothing to think of without it.
std::vector<Effect> stepsOf(const EffectSet& effects) {
    std::vector<Effect> order{Effect::kRefraction, Effect::kEnvironment};
    for (const EffectDecision& decision : effects.decisions)
        if (std::find(order.begin(), order.end(), decision.effect) == order.end()) order.push_back(decision.effect);
    std::erase_if(order, [&](Effect effect) { return !effects.has(effect); });
    return order;
}

EffectSet only(EffectSet effects, const std::vector<Effect>& allowed) {
    for (EffectDecision& decision : effects.decisions)
        decision.on = decision.on && std::find(allowed.begin(), allowed.end(), decision.effect) != allowed.end();
    return effects;
}

bool hasDispersionTexture(const RenderStatistics& statistics) {
    return std::any_of(statistics.textures.begin(), statistics.textures.end(),
                       [](const auto& texture) { return texture.first == "dispersion"; });
}

/// What the march reads for its counts: an evaluation is a fetch of the index, one of Cauchy's B, one of the boundary's band
/// and one of opaque matter, as far as the effects are on; a sample of matter one of each of its grids and two of the bake.
std::uint64_t fetchesOf(const RenderStatistics& counts, const EffectSet& effects, bool lit) {
    const auto on = [&](Effect effect) { return std::uint64_t(effects.has(effect) ? 1 : 0); };
    const std::uint64_t perEvaluation = on(Effect::kRefraction) + std::uint64_t(hasDispersionTexture(counts) ? 1 : 0) +
                                        on(Effect::kReflection) + on(Effect::kOpaque);
    const std::uint64_t perSample =
        on(Effect::kAbsorption) + on(Effect::kEmission) + on(Effect::kScattering) * (lit ? 3 : 1);
    return counts.fieldEvaluations * perEvaluation + counts.matterSamples * perSample + counts.clearanceLookUps;
}

double imageSeconds(const RenderStatistics& statistics) {
    const auto found = std::find_if(statistics.seconds.begin(), statistics.seconds.end(),
                                    [](const auto& stage) { return stage.first == "image"; });
    return found->second;
}

} // namespace

std::vector<Rung> climbLadder(const gpu::Context& context, const Scene& scene, const Fields& fields,
                              const EffectSet& effects, const BakedLight* light, int repeats,
                              const std::function<void(double)>& progress) {
    std::vector<Rung> rungs;
    std::vector<Effect> allowed;
    const std::vector<Effect> order = stepsOf(effects);
    for (const Effect effect : order) {
        allowed.push_back(effect);
        const EffectSet some = only(effects, allowed);
        const BakedLight* shown = some.wantsLight(scene) ? light : nullptr;
        Rung rung{.added = std::string(effectName(effect))};
        for (int i = 0; i < repeats; ++i) {
            progress((double(rungs.size()) + double(i) / repeats) / double(order.size()));
            rung.statistics = renderScene(context, scene, fields, some, shown).statistics;
            const double seconds = imageSeconds(rung.statistics);
            rung.seconds = i == 0 ? seconds : std::min(rung.seconds, seconds);
        }
        rung.fetches = fetchesOf(rung.statistics, some, shown != nullptr);
        rungs.push_back(rung);
    }
    return rungs;
}

std::string ladderCsv(const std::vector<Rung>& rungs) {
    std::string csv = "added,seconds,rays,steps,field_evaluations,clearance_look_ups,matter_samples,fetches,texture_bytes,"
                      "march_instructions\n";
    for (const Rung& rung : rungs) {
        std::size_t bytes = 0;
        for (const auto& texture : rung.statistics.textures) bytes += texture.second;
        const auto instructions = rung.statistics.marchInstructions;
        csv += fmt::format("{},{:.4f},{},{},{},{},{},{},{},{}\n", rung.added, rung.seconds, rung.statistics.rays,
                           rung.statistics.steps, rung.statistics.fieldEvaluations, rung.statistics.clearanceLookUps,
                           rung.statistics.matterSamples, rung.fetches, bytes,
                           instructions ? std::to_string(*instructions) : "");
    }
    return csv;
}

} // namespace eikonal::bench
