#pragma once
// What a change of the scene makes necessary: only what depends on it.

#include "common/scene.h"

namespace eikonal::window {

struct Redo {
    bool camera = false;
    bool exposure = false;
    bool image = false;   ///< kernels and textures of the image
    bool insets = false;  ///< where objects with a resolution of their own are, and with it light
    bool fields = false;  ///< what lies on the grid, and with it image and light
    bool light = false;   ///< the bake

    bool operator==(const Redo&) const = default;
};

/// Compares the values that the two scenes would be written with.
Redo redoFor(const Scene& before, const Scene& after);

/// Whether viewing rays have the same to do in both, but for the effects that they are allowed.
bool differInEffectsOnly(Scene before, const Scene& after);

} // namespace eikonal::window
