#pragma once
// Which lights shine: those of the scene, placed at a frame, and its environment where that lights the bake.

#include <string>
#include <vector>

#include "common/effects.h"
#include "common/scene.h"

namespace eikonal {

struct LightSet {
    std::vector<Light> lights;
    std::vector<DirectionalLight> environment;  ///< beams that stand for it and count as one light
};

/// The lights as the scene has them. Reads the environment's map where it lights the bake; throws badInput as readImage.
LightSet lightsOf(const Scene& scene, const EffectSet& effects);

/// The same with every light where its keyframes have it at a frame.
LightSet lightsAt(const LightSet& lights, double frame);

struct NamedLightSet {
    std::string name;  ///< "light0", "light1", ..., "environment"
    LightSet lights;
};

/// Each light on its own.
std::vector<NamedLightSet> singleLights(const LightSet& lights);

} // namespace eikonal
