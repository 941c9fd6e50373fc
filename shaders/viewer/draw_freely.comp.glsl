// Rays on which nothing acts but the index, from the camera to the film in one go; those that are under way at the end of the slice
// are listed, and go on in a kernel that is the same but for their beginning.
#include "viewer/free_course.glsl"
#include "viewer/end_of_ray.glsl"
#include "viewer/develop.glsl"
#include "viewer/counters.glsl"
#ifdef BEGIN_RAYS
#include "viewer/begin_ray.glsl"
#include "viewer/picture_order.glsl"
#endif

layout(local_size_x = kRaysPerGroup / RAYS_AT_ONCE) in;

#ifdef BEGIN_RAYS
Course courseAt(uint block, int which) {
    Course course;
    uint index = rayInPictureOrder(block, placeInGroup(which), kNoEntry);
    course.entry = index == kNoEntry ? kNoEntry : index | kIsPlain;
    course.ray = beginRay(index == kNoEntry ? 0u : index);
    if (index == kNoEntry) {
        course.ray.status = kMissed;
    }
    course.left = stepsOfSlice(view.rayCount);
    return course;
}
#else
Course courseAt(uint block, int which) {
    return listedCourse(block, which);
}
#endif

// Of each invocation. One adds them up, for the software renderer takes longer over atomic additions, one lane after the other.
shared RayCost costs[gl_WorkGroupSize.x];

// To be called once by every invocation of the group.
void count(RayCost cost) {
    costs[gl_LocalInvocationIndex] = cost;
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        RayCost sum = cost;
        for (uint i = 1u; i < gl_WorkGroupSize.x; ++i) {
            sum = costOfAll(sum, costs[i]);
        }
        addToCounters(sum);
    }
}

// What is to be listed of the ray.
uint drawRay(Course course, inout RayCost cost) {
    if (course.entry == kNoEntry) {
        return kNoEntry;
    }
    rayIndex = course.entry & ~kIsPlain;
    RayState ray = course.ray;
    if (ray.status == kMarching) {
        storeWholeRay(rayIndex, ray);
        return course.entry;
    }
    cost = costOfAll(cost, costOf(ray));
    seeEnd(ray, 0.0);
    develop(view.filmStart + rayIndex, ray);
    return kNoEntry;
}

void main() {
    uint entries[ENTRIES];
    RayCost cost = RayCost(0u, 0u, 0u, 0u);
    for (int turn = 0; turn < BLOCKS_IN_TURN; ++turn) {
        Course courses[RAYS_AT_ONCE];
        for (int i = 0; i < RAYS_AT_ONCE; ++i) {
            courses[i] = courseAt(gl_WorkGroupID.x * uint(BLOCKS_IN_TURN) + uint(turn), i);
        }
        followCourses(courses);
        for (int i = 0; i < RAYS_AT_ONCE; ++i) {
            entries[turn * RAYS_AT_ONCE + i] = drawRay(courses[i], cost);
        }
    }
    count(cost);
    listRays(entries);
}
