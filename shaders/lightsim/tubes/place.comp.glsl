// Place: vertices that the mesh has got, not launched yet.
#include "lightsim/tubes/tubes.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

layout(std430, binding = TUBE_VERTICES_BINDING) writeonly buffer VertexBlock { TubeVertex vertices[]; };
layout(std430, binding = TUBE_ITEMS_BINDING) readonly buffer ItemBlock { TubePlacement placements[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= tube.itemCount) {
        return;
    }
    TubePlacement placement = placements[index];
    vertices[placement.vertex].launch = placement.launch;
    vertices[placement.vertex].frameIndex = placement.frameIndex;
    vertices[placement.vertex].stepCount = TUBE_NOT_LAUNCHED;
    vertices[placement.vertex].ray.blockedAt = 0.0;  // is asked of vertices that are no rays too
}
