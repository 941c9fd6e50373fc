#pragma once
// Meshes made by formula, for demonstrations and tests.

#include "common/mesh.h"

namespace eikonal {

/// A trefoil knot swept by an elliptic, slowly twisting cross-section: closed, smooth, of genus one. Scaled to a longest
/// side of 2 around the origin; the lengths below are in units of half the knot's major radius.
struct KnotOptions {
    int segments = 360;        ///< along the knot
    int sides = 48;            ///< around the tube; even
    double tube = 0.72;        ///< larger half axis of the cross-section
    double flattening = 0.75;  ///< ratio of its half axes
    int twists = 3;            ///< half turns of the cross-section along the knot
};
Mesh generateKnot(const KnotOptions& options = {});

/// Sphere of radius 1 from an icosahedron subdivided `levels` times: 20 · 4^levels triangles.
Mesh generateIcosphere(int levels);

} // namespace eikonal
