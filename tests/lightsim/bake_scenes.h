#pragma once
// Scenes for the light simulator, made in memory.

#include "lightsim/bake.h"
#include "tests/support/synthetic_fields.h"

namespace eikonal::test {

Scene sceneWith(const Light& light);

/// Bakes with the shared context, effects as the scene calls for them.
BakeResult bake(const Scene& scene, const Fields& fields, const BakeOptions& options = {});

/// A glass sphere of radius 0.6 and index 1.5 that absorbs by band, in scattering smoke; the boundary reflects.
Fields absorbingSphereInSmoke(int resolution);

/// A smoothed glass sphere of radius 0.6 and index 1.5 without Fresnel terms: refraction and deposit alone.
Fields clearSphere(int resolution);

/// Σ|a - b| / Σ b over the first band.
double relativeL1(const DenseGrid<glm::vec3>& a, const DenseGrid<glm::dvec3>& b);

} // namespace eikonal::test
