#pragma once
// Boxes around objects.

#include "common/mesh.h"
#include "common/scene.h"

namespace eikonal {

/// The box of an object in its own coordinates and unit. Throws badInput for meshes and volumes that cannot be read.
Bounds boundsOf(const Scene& scene, const Object& object);

/// Whether the boxes of two objects, one of them widened by so many scene units, may have a point in common; never false where
/// they have. Boxes are in their objects' coordinates.
bool mayOverlap(const Object& a, const Bounds& boxOfA, const Object& b, const Bounds& boxOfB, double widening);

} // namespace eikonal
