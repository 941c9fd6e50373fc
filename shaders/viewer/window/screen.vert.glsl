// Corners of one triangle that covers the screen; `at` is (0, 0) in its upper left corner, (1, 1) in its lower right.
out vec2 at;

void main() {
    vec2 corner = vec2(float((gl_VertexID & 1) << 2), float((gl_VertexID & 2) << 1)) - 1.0;
    at = vec2(0.5, -0.5) * corner + 0.5;
    gl_Position = vec4(corner, 0.0, 1.0);
}
