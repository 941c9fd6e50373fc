#include "tools/second_look.h"

#include <nlohmann/json.hpp>

#include "tools/statistics_json.h"

namespace eikonal {

SecondLook::SecondLook(const gpu::Context& context, const Scene& scene, const Fields& fields, const EffectSet& effects) {
    if (hasErrorEstimate(scene.accuracy)) {
        estimator_.emplace(context, scene, fields, effects, BakeOptions{});
    }
}

nlohmann::json SecondLook::estimateJson(const LightSet& lights, const BakedLight& light) {
    return estimator_ ? errorJson(estimator_->estimate(lights, light)) : nlohmann::json(nullptr);
}

} // namespace eikonal
