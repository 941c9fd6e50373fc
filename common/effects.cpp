#include "common/effects.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "common/insets.h"

namespace eikonal {
namespace {

/// Whether a scene calls for an effect, why, and with which grids.
struct Answer {
    bool on = false;
    std::string why;
    std::vector<std::string> grids{};
};

template <class Value>
std::size_t bytesOf(const DenseGrid<Value>& grid) {
    return grid.values.size() * sizeof(Value);
}

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

Answer decideRefraction(const Scene&, const Fields& fields) {
    const auto [low, high] = indexRange(fields);
    if (fields.iorGradient.empty() && (low == high || !anyInset(fields, gpu::kInsetCoverage)))
        return {false, fmt::format("the index is {} everywhere", fields.iorUniform)};
    return {true, fmt::format("the index varies from {:.4g} to {:.4g}", low, high), {"ior"}};
}

Answer decideByMatter(bool present, const std::string& does, std::vector<std::string> grids) {
    if (!present)
        return {false, "nothing " + does};
    return {true, "something " + does, std::move(grids)};
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

Answer decideReflection(const Scene& scene, const Fields& fields) {
    const std::size_t band = boundaryVoxels(fields);
    if (band == 0)
        return {false, "no boundary changes the index"};
    const int generations = scene.accuracy.reflections;
    const std::string followed = generations > 0 ? fmt::format("; followed for {} generations", generations) : "";
    return {true, fmt::format("boundaries that change the index fill {} voxels{}", band, followed), {"interface"}};
}

Answer decideDispersion(const Scene& scene, const Fields& fields) {
    if (!isHeld(fields, fields.cauchyB, gpu::kInsetDispersion))
        return {false, "no object has cauchy_b"};
    const auto& grid = fields.cauchyB.values;
    float strongest = grid.empty() ? 0.0f : *std::max_element(grid.begin(), grid.end());
    for (const Inset& inset : fields.insets)
        strongest = std::max(strongest, inset.grids->quantities[gpu::kInsetDispersion].everywhere.w);
    return {true, fmt::format("cauchy_b is up to {:.4g}; {} bands", strongest, scene.accuracy.bands), {"cauchy_b"}};
}

Answer decideEnvironment(const Scene& scene, const Fields&) {
    const std::string what = scene.environment.image ? scene.environment.image->generic_string()
                             : scene.environment.gradient[0] == scene.environment.gradient[1] ? "one colour" : "a gradient";
    return {true, "the background is " + what};
}

/// All that this program knows of an effect beside its shaders.
struct EffectRow {
    Effect effect;
    std::string_view name;
    Answer (*decide)(const Scene&, const Fields&);
    std::size_t (*bytes)(const Fields&);  ///< of its grids on the domain's lattice
    Effect needs;                         ///< to have something to act on; itself: nothing
    std::string_view without{};           ///< what is missing then
};

/// In the order of the enumeration.
constexpr std::array<EffectRow, 10> kEffects{{
    {Effect::kRefraction, "refraction", decideRefraction,
     [](const Fields& fields) { return bytesOf(fields.ior) + bytesOf(fields.iorGradient); }, Effect::kRefraction},
    {Effect::kAbsorption, "absorption",
     [](const Scene&, const Fields& fields) {
         return decideByMatter(isHeld(fields, fields.sigmaA, gpu::kInsetAbsorption), "absorbs", {"absorption"});
     },
     [](const Fields& fields) { return bytesOf(fields.sigmaA); }, Effect::kAbsorption},
    {Effect::kScattering, "scattering",
     [](const Scene&, const Fields& fields) {
         return decideByMatter(isHeld(fields, fields.sigmaS, gpu::kInsetScattering), "scatters", {"scattering", "anisotropy"});
     },
     [](const Fields& fields) { return bytesOf(fields.sigmaS) + bytesOf(fields.anisotropy) + bytesOf(fields.anisotropyByBand); }, Effect::kScattering},
    {Effect::kEmission, "emission",
     [](const Scene&, const Fields& fields) {
         return decideByMatter(isHeld(fields, fields.emission, gpu::kInsetEmission), "emits", {"emission"});
     },
     [](const Fields& fields) { return bytesOf(fields.emission); }, Effect::kEmission},
    {Effect::kReflection, "reflection", decideReflection, [](const Fields& fields) { return bytesOf(fields.interface); },
     Effect::kReflection},
    {Effect::kTint, "tint",
     [](const Scene&, const Fields& fields) {
         return decideByMatter(isTinted(fields), "tints what it reflects", {"reflection_tint"});
     },
     [](const Fields& fields) { return bytesOf(fields.reflectionTint); }, Effect::kReflection, "nothing is reflected"},
    {Effect::kRoughness, "roughness",
     [](const Scene&, const Fields& fields) { return decideByMatter(isRough(fields), "has a rough surface", {"roughness"}); },
     [](const Fields& fields) { return bytesOf(fields.roughness); }, Effect::kReflection, "nothing is reflected"},
    {Effect::kDispersion, "dispersion", decideDispersion,
     [](const Fields& fields) { return bytesOf(fields.cauchyB) + bytesOf(fields.cauchyGradient); }, Effect::kRefraction,
     "nothing is refracted"},
    {Effect::kOpaque, "opaque",
     [](const Scene&, const Fields& fields) {
         return decideByMatter(isHeld(fields, fields.opaque, gpu::kInsetOpaque), "is opaque", {"opaque", "albedo"});
     },
     [](const Fields& fields) { return bytesOf(fields.opaque) + bytesOf(fields.albedo); }, Effect::kOpaque},
    {Effect::kEnvironment, "environment", decideEnvironment, [](const Fields&) { return std::size_t(0); }, Effect::kEnvironment},
}};

constexpr const EffectRow& rowOf(Effect effect) { return kEffects[std::size_t(effect)]; }

static_assert(std::all_of(kEffects.begin(), kEffects.end(), [](const EffectRow& row) { return &row == &rowOf(row.effect); }));

/// Switches effects off that have nothing to act on without another.
void applyNeeds(EffectSet& set) {
    for (EffectDecision& decision : set.decisions) {
        const EffectRow& row = rowOf(decision.effect);
        if (decision.on && !set.has(row.needs)) {
            decision.on = false;
            decision.why = fmt::format("{}: {}", row.without, set.decisions[std::size_t(row.needs)].why);
        }
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

std::string_view effectName(Effect effect) { return rowOf(effect).name; }

std::size_t gridBytesOf(Effect effect, const Fields& fields) { return rowOf(effect).bytes(fields); }

EffectSet decideEffects(const Scene& scene, const Fields& fields) {
    EffectSet set;
    for (const EffectRow& row : kEffects) {
        Answer answer = row.decide(scene, fields);
        set.decisions.push_back({row.effect, answer.on, std::move(answer.why), std::move(answer.grids)});
    }
    applyAllowed(scene, set);
    applyNeeds(set);
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
