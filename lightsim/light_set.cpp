#include "lightsim/light_set.h"

#include "common/environment_lights.h"
#include "common/light_motion.h"

namespace eikonal {

LightSet lightsOf(const Scene& scene, const EffectSet& effects) {
    LightSet lights{scene.lights, {}};
    if (scene.environment.bake && effects.has(Effect::kEnvironment)) {
        const std::optional<Image> image = environmentImage(scene);
        lights.environment = environmentLights(EnvironmentCells(scene.environment, image ? &*image : nullptr),
                                               scene.environment.lights);
    }
    return lights;
}

LightSet lightsAt(const LightSet& lights, double frame) {
    LightSet placed{{}, lights.environment};
    for (const Light& light : lights.lights) {
        placed.lights.push_back(lightAt(light, frame));
    }
    return placed;
}

std::vector<NamedLightSet> singleLights(const LightSet& lights) {
    std::vector<NamedLightSet> single;
    for (std::size_t i = 0; i < lights.lights.size(); ++i) {
        single.push_back({"light" + std::to_string(i), {{lights.lights[i]}, {}}});
    }
    if (!lights.environment.empty()) {
        single.push_back({"environment", {{}, lights.environment}});
    }
    return single;
}

} // namespace eikonal
