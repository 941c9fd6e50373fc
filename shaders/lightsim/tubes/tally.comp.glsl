// Tally: the stories of the rays become the energy ledger. Every ray stands for the power about its launch coordinate.
#include "lightsim/tubes/tubes.glsl"
#include "lightsim/ledger.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

layout(std430, binding = TUBE_VERTICES_BINDING) readonly buffer VertexBlock { TubeVertex vertices[]; };
layout(std430, binding = TUBE_RESULTS_BINDING) readonly buffer PowerBlock { vec4 powers[]; };  // of the vertices, by band

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= tube.itemCount || largestOf(powers[index].rgb) <= 0.0) {
        return;
    }
    EnergyRows rows = rowsOf(vertices[index].ray);
    for (int row = 0; row < LEDGER_ROWS; ++row) {
        enterInLedger(row, powers[index].rgb * rows.share[row]);
    }
}
