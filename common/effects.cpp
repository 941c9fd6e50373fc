#include "common/effects.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace eikonal {
namespace {

constexpr std::array<std::string_view, 10> kEffectNames{"refraction", "absorption", "scattering", "emission",
                                                        "reflection", "tint",       "roughness",  "dispersion",
                                                        "opaque",     "environment"};

EffectDecision decideRefraction(const Fields& fields) {
    if (fields.iorGradient.empty())
        return {Effect::kRefraction, false, fmt::format("the index is {} everywhere", fields.iorUniform), {}};
    const auto [low, high] = std::minmax_element(fields.ior.values.begin(), fields.ior.values.end());
    return {Effect::kRefraction, true, fmt::format("the index varies from {:.4g} to {:.4g}", *low, *high), {"ior"}};
}

EffectDecision decideByGrid(Effect effect, bool present, const std::string& matter, std::vector<std::string> grids) {
    if (!present)
        return {effect, false, "nothing " + matter, {}};
    return {effect, true, "something " + matter, std::move(grids)};
}

EffectDecision decideReflection(const Scene& scene, const Fields& fields) {
    const auto& mask = fields.interface.values;
    const auto band = std::count_if(mask.begin(), mask.end(), [](unsigned char value) { return value != 0; });
    if (band == 0)
        return {Effect::kReflection, false, "no boundary changes the index", {}};
    const int generations = scene.accuracy.reflections;
    const std::string followed = generations > 0 ? fmt::format("; followed for {} generations", generations) : "";
    return {Effect::kReflection, true, fmt::format("boundaries that change the index fill {} voxels{}", band, followed),
            {"interface"}};
}

EffectDecision decideDispersion(const Scene& scene, const Fields& fields) {
    if (fields.cauchyB.empty())
        return {Effect::kDispersion, false, "no object has cauchy_b", {}};
    const double strongest = *std::max_element(fields.cauchyB.values.begin(), fields.cauchyB.values.end());
    const std::string why = fmt::format("cauchy_b is up to {:.4g}; {} bands", strongest, scene.accuracy.bands);
    return {Effect::kDispersion, true, why, {"cauchy_b"}};
}

EffectDecision decideEnvironment(const Scene& scene) {
    const std::string what = scene.environment.image ? scene.environment.image->generic_string() : "a gradient";
    return {Effect::kEnvironment, true, "the background is " + what, {}};
}

/// Switches an effect off that has nothing to act on without another.
void applyDependence(EffectSet& set, Effect dependent, Effect on, const std::string& without) {
    EffectDecision& decision = set.decisions[std::size_t(dependent)];
    const EffectDecision& needed = set.decisions[std::size_t(on)];
    if (decision.on && !needed.on) {
        decision.on = false;
        decision.why = without + ": " + needed.why;
    }
}

void applyAllowed(const Scene& scene, EffectSet& set) {
    if (!scene.render.effects)
        return;
    const std::vector<std::string>& allowed = *scene.render.effects;
    for (EffectDecision& decision : set.decisions) {
        const bool named = std::find(allowed.begin(), allowed.end(), effectName(decision.effect)) != allowed.end();
        if (decision.on && !named) {
            decision.on = false;
            decision.why = "left out by render.effects, though " + decision.why;
        }
    }
}

} // namespace

std::string_view effectName(Effect effect) { return kEffectNames[std::size_t(effect)]; }

EffectSet decideEffects(const Scene& scene, const Fields& fields) {
    EffectSet set;
    set.decisions = {
        decideRefraction(fields),
        decideByGrid(Effect::kAbsorption, !fields.sigmaA.empty(), "absorbs", {"absorption"}),
        decideByGrid(Effect::kScattering, !fields.sigmaS.empty(), "scatters", {"scattering", "anisotropy"}),
        decideByGrid(Effect::kEmission, !fields.emission.empty(), "emits", {"emission"}),
        decideReflection(scene, fields),
        decideByGrid(Effect::kTint, !fields.reflectionTint.empty(), "tints what it reflects", {"reflection_tint"}),
        decideByGrid(Effect::kRoughness, !fields.roughness.empty(), "has a rough surface", {"roughness"}),
        decideDispersion(scene, fields),
        decideByGrid(Effect::kOpaque, !fields.opaque.empty(), "is opaque", {"opaque", "albedo"}),
        decideEnvironment(scene),
    };
    applyAllowed(scene, set);
    applyDependence(set, Effect::kDispersion, Effect::kRefraction, "nothing is refracted");
    applyDependence(set, Effect::kTint, Effect::kReflection, "nothing is reflected");
    applyDependence(set, Effect::kRoughness, Effect::kReflection, "nothing is reflected");
    return set;
}

EffectSet EffectSet::without(Effect effect) const {
    EffectSet set = *this;
    set.decisions[std::size_t(effect)].on = false;
    return set;
}

std::vector<std::string> EffectSet::defines() const {
    std::vector<std::string> names;
    for (const EffectDecision& decision : decisions) {
        if (!decision.on)
            continue;
        std::string name = "EFFECT_";
        for (const char c : effectName(decision.effect))
            name += char(c - 'a' + 'A');
        names.push_back(name);
    }
    return names;
}

bool EffectSet::wantsLight(const Scene& scene) const {
    const bool lit = !scene.lights.empty() || (scene.environment.bake && has(Effect::kEnvironment));
    return lit && (has(Effect::kScattering) || has(Effect::kOpaque));
}

} // namespace eikonal
