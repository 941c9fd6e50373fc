// A slice of rays on which nothing acts but the index: all that can happen to one is that it leaves the domain.
#include "viewer/free_steps.glsl"
#include "viewer/event.glsl"

layout(local_size_x = kRaysPerGroup / RAYS_AT_ONCE) in;

struct Course {
    uint entry;
    RayState ray;
    uint left;  // steps and flights of the slice
    FreeSteps steps;
};

// Those of a vector of eight invocations follow each other in the list.
uint placeInList(uint which) {
    uint i = gl_LocalInvocationIndex;
    return gl_WorkGroupID.x * uint(kRaysPerGroup) + (i & ~7u) * uint(RAYS_AT_ONCE) + 8u * which + (i & 7u);
}

Course courseAt(uint place) {
    Course course;
    course.entry = entryAt(place);
    bool isListed = course.entry != kNoEntry;
    course.ray = loadRay(isListed ? course.entry & ~kIsPlain : 0u);
    if (!isListed) {
        course.ray.status = kMissed;
    }
    course.left = stepsOfSlice();
    return course;
}

// Steps of rays side by side, each until it may leave the domain or fly, or has come to the slice's end.
void stepAlong(inout Course courses[RAYS_AT_ONCE], vec3 stepScale) {
    bool goesOn = false;
    for (int i = 0; i < RAYS_AT_ONCE; ++i) {
        courses[i].steps = beginSteps(courses[i].ray, courses[i].left, stepScale);
        goesOn = goesOn || courses[i].steps.goOn;
    }
    while (goesOn) {
        goesOn = false;
        for (int i = 0; i < RAYS_AT_ONCE; ++i) {
            takeStep(courses[i].steps, stepScale);
            goesOn = goesOn || courses[i].steps.goOn;
        }
    }
}

bool followOn(inout Course course, vec3 stepScale) {
    if (endSteps(course.ray, course.left, course.steps, stepScale)) {
        takeEventfulStep(course.ray);
        course.left -= 1u;
    }
    return course.left > 0u && course.ray.status == kMarching;
}

uint pass(Course course) {
    if (course.entry == kNoEntry) {
        return kNoEntry;
    }
    rayIndex = course.entry & ~kIsPlain;
    return passOn(course.ray, false);
}

void main() {
    vec3 stepScale = view.stepLength * domain.scale;
    Course courses[RAYS_AT_ONCE];
    for (int i = 0; i < RAYS_AT_ONCE; ++i) {
        courses[i] = courseAt(placeInList(uint(i)));
    }
    bool goesOn;
    do {
        for (int i = 0; i < RAYS_AT_ONCE; ++i) {
            flyAhead(courses[i].ray, courses[i].left);
        }
        stepAlong(courses, stepScale);
        goesOn = false;
        for (int i = 0; i < RAYS_AT_ONCE; ++i) {
            bool on = followOn(courses[i], stepScale);
            goesOn = goesOn || on;
        }
    } while (goesOn);
    uint entries[RAYS_AT_ONCE];
    for (int i = 0; i < RAYS_AT_ONCE; ++i) {
        entries[i] = pass(courses[i]);
    }
    listRays(entries);
}
