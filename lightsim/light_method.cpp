#include "lightsim/light_method.h"

#include "lightsim/patch_method.h"
#include "lightsim/settings.h"
#include "lightsim/tubes/tube_bake.h"

namespace eikonal::bake {

std::unique_ptr<LightMethod> makeMethod(const gpu::Context& context, const MethodPlan& plan, const BakeOptions& options,
                                        const LaunchGrids& grids, const BakeSettings& settings) {
    if (usesPatches(plan.accuracy)) {
        return std::make_unique<PatchMethod>(context, plan, grids, settings);
    }
    return std::make_unique<TubeBake>(context, plan, options, grids, settings);
}

} // namespace eikonal::bake
