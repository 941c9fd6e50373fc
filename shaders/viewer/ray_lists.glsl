// Lists of rays under way: a dispatch takes those of one list, so that its vectors hold none that have nothing to do, and fills the
// other with those that are to go on. Rays that begin have the places that the picture's order gives them, which keeps vectors to
// neighbouring pixels; where none begins the place is empty.
#include "shared/view_blocks.h"

layout(std430, binding = kStorageTakenRays) readonly buffer TakenRays {
    RayListHead takenHead;
    uint takenRays[];
};
layout(std430, binding = kStorageFilledRays) buffer FilledRays {
    RayListHead filledHead;
    uint filledRays[];
};

// That an invocation leaves at most.
#ifndef ENTRIES
#define ENTRIES 1
#endif

shared uint listedOfGroup;  // entries
shared uint placeOfGroup;   // of the first one

// To be called once by every invocation of the group. Its entries follow each other in the list, so that rays stay beside those
// of their neighbours in the picture, which go the same way.
void listRays(uint entries[ENTRIES]) {
    bool isFirst = gl_LocalInvocationIndex == 0u;
    if (isFirst) {
        listedOfGroup = 0u;
    }
    barrier();
    uint places[ENTRIES];
    for (int i = 0; i < ENTRIES; ++i) {
        places[i] = entries[i] == kNoEntry ? 0u : atomicAdd(listedOfGroup, 1u);
    }
    barrier();
    if (isFirst && listedOfGroup > 0u) {
        placeOfGroup = atomicAdd(filledHead.count, listedOfGroup);
        uint groups = (placeOfGroup + listedOfGroup + uint(kRaysPerGroup) - 1u) / uint(kRaysPerGroup);
        atomicMax(filledHead.groups[0], groups);
    }
    barrier();
    for (int i = 0; i < ENTRIES; ++i) {
        if (entries[i] != kNoEntry) {
            filledRays[placeOfGroup + places[i]] = entries[i];
        }
    }
}

#if ENTRIES == 1
void listRay(uint entry) {
    listRays(uint[1](entry));
}
#endif

// In place of listRay where every invocation has a place of its own; the head is filled beforehand.
void listAtOwnPlace(uint entry) {
    filledRays[gl_GlobalInvocationID.x] = entry;
}

// Of each of so many rays: fewer where there are many, so that no dispatch takes long.
uint stepsOfSlice(uint rays) {
    return clamp(view.stepsPerDispatch / max(rays, 1u), 1u, view.stepsPerSlice);
}

uint entryAt(uint place) {
    return place < takenHead.count ? takenRays[place] : kNoEntry;
}

// For this invocation.
uint listedEntry() {
    return entryAt(gl_GlobalInvocationID.x);
}
