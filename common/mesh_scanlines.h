#pragma once
// Where lines parallel to an axis cross a mesh: the inside of a solid without any search, exact at shared edges.

#include <vector>

#include <glm/glm.hpp>

#include "common/mesh.h"

namespace eikonal {

/// A bundle of lines along `axis` through the points of a regular raster over the two following axes (cyclic).
struct ScanRaster {
    int axis = 0;
    glm::dvec2 first{0.0};  ///< coordinates of line (0, 0) on axes (axis + 1) % 3 and (axis + 2) % 3
    double spacing = 1.0;
    glm::ivec2 count{0};
};

struct Crossing {
    double at = 0.0;      ///< coordinate along the axis
    int winding = 0;      ///< +1: the line enters through a front face, -1: it leaves
    int triangle = 0;
};

/// Crossings of each line, sorted along it; line (u, v) at v · count.x + u. A line through an edge or a vertex crosses
/// exactly one of the triangles on either side (ties broken as rasterizers do), so that closed meshes give winding
/// numbers that return to zero.
std::vector<std::vector<Crossing>> scanMesh(const Mesh& mesh, const ScanRaster& raster);

} // namespace eikonal
