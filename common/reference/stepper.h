#pragma once
// The integrators of shaders/physics over any field, in double precision, with their field evaluations counted.
// Includes common/physics.h: for .cpp files only.

#include <cstdint>

#include "common/physics.h"
#include "common/reference/reference_field.h"

namespace eikonal::f64 {

/// Field: anything with `reference::Optics optics(const glm::dvec3&) const`.
template <class Field>
class Stepper {
public:
    using Optics = reference::Optics;

    explicit Stepper(const Field& field) : field_(field) {}

#include "shaders/physics/step_euler.glsl"
#include "shaders/physics/step_leapfrog.glsl"
#include "shaders/physics/step_rk4.glsl"
#include "shaders/physics/step_sharma.glsl"

    std::uint64_t evaluations() const { return evaluations_; }

private:
    Optics sampleOptics(const real3& x) {
        ++evaluations_;
        return field_.optics(x);
    }

    const Field& field_;
    std::uint64_t evaluations_ = 0;
};

} // namespace eikonal::f64
