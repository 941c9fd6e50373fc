// The picture, scaled to the screen.
layout(binding = 0) uniform sampler2D picture;

in vec2 at;
out vec4 color;

void main() {
    // Half a texel from the edges: beyond, the texture repeats.
    vec2 halfTexel = 0.5 / vec2(textureSize(picture, 0));
    color = vec4(texture(picture, clamp(at, halfTexel, 1.0 - halfTexel)).rgb, 1.0);
}
