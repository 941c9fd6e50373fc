// What the kernels of the bake by ray tubes share.
#include "lightsim/settings.glsl"
#include "shared/tube_blocks.h"
#include "shared/domain_block.h"

layout(std140, binding = TUBE_SETTINGS_BINDING) uniform TubeBlock {
    TubeSettings tube;
};

// Whether a point is within a margin of the domain.
bool withinDomain(vec3 x, float margin) {
    return all(greaterThan(x, domain.min - margin)) && all(lessThan(x, domain.max + margin));
}

float largestOf(vec3 value) {
    return max(value.x, max(value.y, value.z));
}
