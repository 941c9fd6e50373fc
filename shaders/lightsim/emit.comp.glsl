// Emit: free places of the pool are filled, first with patches that wait as launch records, then with new cells of the
// lights' launch grids. Four invocations a patch, one for each corner.
#include "lightsim/bake.glsl"
#include "lightsim/particle.glsl"
#include "lightsim/launch.glsl"

layout(local_size_x = BAKE_GROUP_SIZE) in;

layout(std430, binding = BAKE_FRAMES_BINDING) readonly buffer FrameBlock { LaunchFrame frames[]; };
layout(std430, binding = BAKE_RECORDS_BINDING) readonly buffer RecordBlock { LaunchRecord records[]; };

// The frame that holds a cell: the last one that begins at or before it.
uint frameOfCell(uint cell) {
    uint low = 0u;
    uint high = uint(frames.length()) - 1u;
    while (low < high) {
        uint middle = (low + high + 1u) / 2u;
        if (frames[middle].firstCell <= cell) {
            low = middle;
        } else {
            high = middle - 1u;
        }
    }
    return low;
}

LaunchRecord recordOfCell(uint cell) {
    LaunchRecord record;
    record.frameIndex = frameOfCell(cell);
    LaunchFrame frame = frames[record.frameIndex];
    uint local = cell - frame.firstCell;
    vec2 place = vec2(float(local % frame.cellsU), float(local / frame.cellsU));
    vec2 cells = vec2(float(frame.cellsU), float(frame.cellsV));
    record.launchMin = 2.0 * place / cells - 1.0;
    record.launchMax = 2.0 * (place + 1.0) / cells - 1.0;
    record.stepCount = 0u;
    record.orientation = 0u;
    record.unusedA = 0u;
    return record;
}

void begin(uint slot, LaunchRecord record) {
    patches[slot].launchMin = record.launchMin;
    patches[slot].launchMax = record.launchMax;
    patches[slot].power = launchPower(frames[record.frameIndex], record.launchMin, record.launchMax);
    patches[slot].frameIndex = record.frameIndex;
    patches[slot].stepCount = record.stepCount;
    patches[slot].orientation = record.orientation;
    appendLive(slot);
}

void main() {
    uint index = gl_GlobalInvocationID.x / 4u;
    uint corner = gl_GlobalInvocationID.x % 4u;
    if (index >= queue.emitCount) {
        return;
    }
    LaunchRecord record;
    if (index < queue.recordTake) {
        record = records[queue.recordCount - 1u - index];
    } else {
        record = recordOfCell(queue.nextCell + index - queue.recordTake);
    }
    uint slot = slotLists[FREE_RING * settings.capacity + (queue.freeHead + index) % settings.capacity];
    vec2 launch = vec2(corner == 1u || corner == 2u ? record.launchMax.x : record.launchMin.x,
                       corner >= 2u ? record.launchMax.y : record.launchMin.y);
    uint evaluations = 0u;
    patches[slot].corners[corner] = tracedParticle(frames[record.frameIndex], launch, record.stepCount, evaluations);
    if (corner == 0u) {
        begin(slot, record);
    }
    countEvaluations(evaluations);
}
