// Linear radiance to display-encoded values from 0 to 1.
#include "physics/tone.glsl"
#include "viewer/film_pixels.glsl"

layout(local_size_x = kRaysPerGroup) in;

layout(std430, binding = kStorageDisplay) writeonly buffer Display { vec4 display[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= view.rayCount) {
        return;
    }
    vec3 radiance = filmRow(filmTexels, index, kRadianceRow).rgb * view.exposureScale;
#if defined(TONE_AGX)
    radiance = toneAgx(radiance);
#elif defined(TONE_REINHARD)
    radiance = toneReinhard(radiance);
#endif
    display[index] = vec4(srgbEncoded3(radiance), 1.0);
}
