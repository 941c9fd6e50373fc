// The ways of an invocation's rays through the domain, by free steps and flights, in turns.
#include "viewer/free_steps.glsl"
#include "viewer/event.glsl"

struct Course {
    uint entry;
    RayState ray;
    uint left;  // steps and flights of the slice
    FreeSteps steps;
};

// Of the workgroup's rays: those of a vector of eight invocations follow each other.
uint placeInGroup(int which) {
    uint i = gl_LocalInvocationIndex;
    return (i & ~7u) * uint(RAYS_AT_ONCE) + 8u * uint(which) + (i & 7u);
}

// Of a ray on the list that is taken, of the block at a place of it.
Course listedCourse(uint block, int which) {
    Course course;
    course.entry = entryAt(block * uint(kRaysPerGroup) + placeInGroup(which));
    bool isListed = course.entry != kNoEntry;
    course.ray = loadRay(isListed ? course.entry & ~kIsPlain : 0u);
    if (!isListed) {
        course.ray.status = kMissed;
    }
    course.left = stepsOfSlice(takenHead.count);
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

// Each to its end, or to that of the slice.
void followCourses(inout Course courses[RAYS_AT_ONCE]) {
    vec3 stepScale = view.stepLength * domain.scale;
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
}
