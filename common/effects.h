#pragma once
// Effects are data: one function looks at a resolved scene and answers which effects it calls for, and why.
// Stages that run, textures that are uploaded and #defines of the kernels all follow from that answer.

#include <string>
#include <string_view>
#include <vector>

#include "common/fields.h"
#include "common/scene.h"

namespace eikonal {

enum class Effect {
    kRefraction,
    kAbsorption,
    kScattering,
    kEmission,
    kReflection,
    kTint,
    kRoughness,
    kDispersion,
    kOpaque,
    kEnvironment
};

/// One row of the table that `info` and the statistics show.
struct EffectDecision {
    Effect effect;
    bool on = false;
    std::string why;
    std::vector<std::string> grids;  ///< grids it needs, by their names in files
};

/// The decision on all effects, in the order of the enumeration.
struct EffectSet {
    std::vector<EffectDecision> decisions;

    bool has(Effect effect) const { return decisions[std::size_t(effect)].on; }
    /// The same with an effect off.
    EffectSet without(Effect effect) const;
    /// `#define`s that kernels are compiled with: "EFFECT_REFRACTION", ...
    std::vector<std::string> defines() const;
    /// Light is simulated only for what shows it: matter that scatters, or a lit opaque surface.
    bool wantsLight(const Scene& scene) const;
};

std::string_view effectName(Effect effect);

/// Bytes in memory of the grids that an effect needs, on the domain's lattice.
std::size_t gridBytesOf(Effect effect, const Fields& fields);

EffectSet decideEffects(const Scene& scene, const Fields& fields);

} // namespace eikonal
