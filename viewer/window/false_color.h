#pragma once
// The colours that kernels show values in, for legends.

#include <glm/glm.hpp>

namespace eikonal::window {

/// For a value from 0 to 1: display-encoded, 0 to 1 (shaders/viewer/false_color.glsl).
glm::vec3 falseColor(float value);

} // namespace eikonal::window
