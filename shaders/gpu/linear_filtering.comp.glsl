// What the texture unit makes of a ramp from 0 to 1 between two texels, at fractions of 1/1024. Units with few bits of
// weight give steps; then the fields are filtered by hand.

layout(local_size_x = 64) in;

layout(binding = 0) uniform sampler3D ramp;

layout(std430, binding = 0) writeonly buffer Values { float values[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    float fraction = float(index) / 1024.0;
    values[index] = textureLod(ramp, vec3(0.25 + 0.5 * fraction, 0.5, 0.5), 0.0).r;
}
