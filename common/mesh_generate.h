#pragma once
// Meshes made by formula, for demonstrations and tests.

#include "common/mesh.h"

namespace eikonal {

/// A trefoil knot swept by an elliptic, slowly twisting cross-section: closed, smooth, of genus one.
/// Fits the box of edge 2 around the origin.
struct KnotOptions {
    int segments = 360;      ///< along the knot
    int sides = 48;          ///< around the tube
    double tube = 0.30;      ///< half width of the tube [units of the knot's major radius]
    double flattening = 0.72;  ///< ratio of the cross-section's half axes
    int twists = 3;          ///< half turns of the cross-section along the knot
};
Mesh generateKnot(const KnotOptions& options = {});

/// Sphere of radius 1 from an icosahedron subdivided `levels` times: 20 · 4^levels triangles.
Mesh generateIcosphere(int levels);

} // namespace eikonal
