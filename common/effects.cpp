#include "common/effects.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "common/insets.h"

namespace eikonal {
namespace {

constexpr std::array<std::string_view, 10> kEffectNames{"refraction", "absorption", "scattering", "emission",
                                                        "reflection", "tint",       "roughness",  "dispersion",
                                                        "opaque",     "environment"};

bool anyInset(const Fields& fields, int quantity) {
    return std::any_of(fields.insets.begin(), fields.insets.end(),
                       [quantity](const Inset& inset) { return inset.grids->has(quantity); });
}

/// Whether something holds a quantity: the domain's grid of it, or an inset.
template <class Value>
bool isHeld(const Fields& fields, const DenseGrid<Value>& grid, int quantity) {
    return !grid.empty() || anyInset(fields, quantity);
}

/// Least and greatest index of all that there is.
std::pair<float, float> indexRange(const Fields& fields) {
    std::pair<float, float> range{fields.iorUniform, fields.iorUniform};
    if (!fields.ior.empty()) {
        const auto [low, high] = std::minmax_element(fields.ior.values.begin(), fields.ior.values.end());
        range = {*low, *high};
    }
    for (const Inset& inset : fields.insets)
        range = {std::min(range.first, inset.grids->iorMin), std::max(range.second, inset.grids->iorMax)};
    return range;
}

EffectDecision decideRefraction(const Fields& fields) {
    const auto [low, high] = indexRange(fields);
    if (fields.iorGradient.empty() && (low == high || !anyInset(fields, gpu::kInsetCoverage)))
        return {Effect::kRefraction, false, fmt::format("the index is {} everywhere", fields.iorUniform), {}};
    return {Effect::kRefraction, true, fmt::format("the index varies from {:.4g} to {:.4g}", low, high), {"ior"}};
}

EffectDecision decideByGrid(Effect effect, bool present, const std::string& matter, std::vector<std::string> grids) {
    if (!present)
        return {effect, false, "nothing " + matter, {}};
    return {effect, true, "something " + matter, std::move(grids)};
}

std::size_t marked(const DenseGrid<unsigned char>& band) {
    return std::size_t(std::count_if(band.values.begin(), band.values.end(), [](unsigned char value) { return value != 0; }));
}

/// Voxels in the bands of boundaries, on the domain's lattice and on insets' own.
std::size_t boundaryVoxels(const Fields& fields) {
    constexpr float kLeastContrast = 1e-4f;  // below it the reflectance is under 1e-9
    const auto [low, high] = indexRange(fields);
    std::size_t voxels = marked(fields.interface);
    for (const Inset& inset : fields.insets)
        voxels += high - low > kLeastContrast ? marked(inset.grids->boundary) : 0;
    return voxels;
}

/// Whether the surface of an inset's boundary, tint in xyz and roughness in w, `differs` from a plain one.
template <class Differs>
bool anySurface(const Fields& fields, const Differs& differs) {
    return std::any_of(fields.insets.begin(), fields.insets.end(), [&](const Inset& inset) {
        return !inset.grids->boundary.empty() && differs(inset.grids->quantities[gpu::kInsetSurface].everywhere);
    });
}

bool isTinted(const Fields& fields) {
    return !fields.reflectionTint.empty() ||
           anySurface(fields, [](const glm::vec4& surface) { return glm::vec3(surface) != glm::vec3(1.0f); });
}

bool isRough(const Fields& fields) {
    return !fields.roughness.empty() || anySurface(fields, [](const glm::vec4& surface) { return surface.w > 0.0f; });
}

EffectDecision decideReflection(const Scene& scene, const Fields& fields) {
    const std::size_t band = boundaryVoxels(fields);
    if (band == 0)
        return {Effect::kReflection, false, "no boundary changes the index", {}};
    const int generations = scene.accuracy.reflections;
    const std::string followed = generations > 0 ? fmt::format("; followed for {} generations", generations) : "";
    return {Effect::kReflection, true, fmt::format("boundaries that change the index fill {} voxels{}", band, followed),
            {"interface"}};
}

EffectDecision decideDispersion(const Scene& scene, const Fields& fields) {
    if (!isHeld(fields, fields.cauchyB, gpu::kInsetDispersion))
        return {Effect::kDispersion, false, "no object has cauchy_b", {}};
    const auto& grid = fields.cauchyB.values;
    float strongest = grid.empty() ? 0.0f : *std::max_element(grid.begin(), grid.end());
    for (const Inset& inset : fields.insets)
        strongest = std::max(strongest, inset.grids->quantities[gpu::kInsetDispersion].everywhere.w);
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
    const auto holds = [&](const auto& grid, int quantity) { return isHeld(fields, grid, quantity); };
    set.decisions = {
        decideRefraction(fields),
        decideByGrid(Effect::kAbsorption, holds(fields.sigmaA, gpu::kInsetAbsorption), "absorbs", {"absorption"}),
        decideByGrid(Effect::kScattering, holds(fields.sigmaS, gpu::kInsetScattering), "scatters",
                     {"scattering", "anisotropy"}),
        decideByGrid(Effect::kEmission, holds(fields.emission, gpu::kInsetEmission), "emits", {"emission"}),
        decideReflection(scene, fields),
        decideByGrid(Effect::kTint, isTinted(fields), "tints what it reflects", {"reflection_tint"}),
        decideByGrid(Effect::kRoughness, isRough(fields), "has a rough surface", {"roughness"}),
        decideDispersion(scene, fields),
        decideByGrid(Effect::kOpaque, holds(fields.opaque, gpu::kInsetOpaque), "is opaque", {"opaque", "albedo"}),
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
