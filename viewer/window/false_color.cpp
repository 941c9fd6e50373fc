#include "viewer/window/false_color.h"

namespace eikonal::window {

namespace {

using glm::dot, glm::vec2, glm::vec3, glm::vec4;

// No templates, so that the shading language's literals convert.
float clamp(float x, float low, float high) { return glm::clamp(x, low, high); }
vec3 clamp(const vec3& x, float low, float high) { return glm::clamp(x, low, high); }

#include "shaders/viewer/false_color.glsl"

} // namespace

glm::vec3 falseColor(float value) { return turbo(value); }

} // namespace eikonal::window
