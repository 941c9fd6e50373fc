#pragma once
// What each effect costs: pure bookkeeping of how long pictures took with it and without it.

#include <map>
#include <optional>
#include <vector>

#include "common/effects.h"

namespace eikonal::window {

class EffectCosts {
public:
    /// A ray took so long with these effects.
    void measured(const EffectSet& effects, double secondsPerRay);
    /// Seconds that an effect adds to a ray beside the others that are on, where both ways have been measured.
    std::optional<double> cost(const EffectSet& effects, Effect effect) const;
    /// Another scene, or another view of it.
    void clear() { seconds_.clear(); }

private:
    std::map<std::vector<bool>, double> seconds_;  ///< a ray, by what is on
};

} // namespace eikonal::window
