#pragma once
// What bakes are followed by for their statistics: an estimate of their error.

#include <optional>

#include <nlohmann/json_fwd.hpp>

#include "lightsim/error_estimate.h"

namespace eikonal {

/// For any number of bakes of a scene.
class SecondLook {
public:
    /// As BakeErrorEstimator.
    SecondLook(const gpu::Context& context, const Scene& scene, const Fields& fields, const EffectSet& effects);

    /// `error_estimate`: null where a bake has none.
    nlohmann::json estimateJson(const LightSet& lights, const BakedLight& light);

private:
    std::optional<BakeErrorEstimator> estimator_;
};

} // namespace eikonal
