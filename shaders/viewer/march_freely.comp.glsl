// A slice of rays on which nothing acts but the index: all that can happen to one is that it leaves the domain.
#include "viewer/free_course.glsl"

layout(local_size_x = kRaysPerGroup / RAYS_AT_ONCE) in;

uint pass(Course course) {
    if (course.entry == kNoEntry) {
        return kNoEntry;
    }
    rayIndex = course.entry & ~kIsPlain;
    return passOn(course.ray, false);
}

void main() {
    Course courses[RAYS_AT_ONCE];
    for (int i = 0; i < RAYS_AT_ONCE; ++i) {
        courses[i] = listedCourse(gl_WorkGroupID.x, i);
    }
    followCourses(courses);
    uint entries[RAYS_AT_ONCE];
    for (int i = 0; i < RAYS_AT_ONCE; ++i) {
        entries[i] = pass(courses[i]);
    }
    listRays(entries);
}
