// Adds a sample of every pixel to the film.
#include "viewer/develop.glsl"

layout(local_size_x = kRaysPerGroup) in;

void main() {
    uint index = gl_GlobalInvocationID.x;
    RayState ray = loadRay(min(index, view.rayCount - 1u));
    if (index < view.rayCount && isFollowed(ray)) {
        develop(view.filmStart + index, ray);
    }
}
