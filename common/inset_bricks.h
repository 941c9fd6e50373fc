#pragma once
// Which insets are where, brick by brick of the domain (common/field_pyramid.h).

#include <cstdint>

#include "common/field_pyramid.h"
#include "common/insets.h"

namespace eikonal {

struct InsetBrick {
    std::uint32_t about = 0;   ///< a bit for each inset that holds something in the brick or within a voxel of it
    float finestVoxel = 1.0f;  ///< edge of the finest voxel of those over that of the domain's, 1 at most
};

DenseGrid<InsetBrick> insetBricksOf(const Fields& fields);

/// How fine insets are and how they lie, for what goes by it.
struct InsetBounds {
    double finestVoxel = 1.0;  ///< edge of the finest voxel over that of the domain's, 1 at most
    int mostAbout = 0;         ///< insets about one brick
};

InsetBounds boundsOf(const DenseGrid<InsetBrick>& bricks);

/// Adds what insets hold to the bricks of the domain's own grids.
void addInsets(const Fields& fields, FieldPyramid& pyramid);

} // namespace eikonal
