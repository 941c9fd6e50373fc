#pragma once
// The equations of shaders/physics as C++, in double (f64) and in float (f32): the very lines that the GPU runs.
// They live in unnamed namespaces because the shading language has no word for inline; include this in .cpp files only.

#include <cmath>

#include <glm/glm.hpp>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-const-variable"
#pragma GCC diagnostic ignored "-Wfloat-conversion"

namespace eikonal::f64 {
namespace {
using real = double;
using real2 = glm::dvec2;
using real3 = glm::dvec3;
using real4 = glm::dvec4;
#include "common/physics_list.inc"
} // namespace
} // namespace eikonal::f64

namespace eikonal::f32 {
namespace {
using real = float;
using real2 = glm::vec2;
using real3 = glm::vec3;
using real4 = glm::vec4;
#include "common/physics_list.inc"
} // namespace
} // namespace eikonal::f32

#pragma GCC diagnostic pop
