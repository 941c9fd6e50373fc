#pragma once
// Where rays run straight: a coarse grid of bricks over the lattice that bounds what the fields hold, and how far a ray can
// go from a brick before it meets something (docs/physics.md, section 1).

#include <functional>

#include "common/fields.h"
#include "shaders/shared/brick.h"

namespace eikonal {

/// Edge of a brick [voxels]. Bricks at the upper faces may be cut.
inline constexpr int kBrickVoxels = gpu::kBrickVoxels;

/// What trilinear interpolation finds at any point of a brick: bounds over its voxels and one more all round.
struct FieldBrick {
    float iorMin = 1.0f, iorMax = 1.0f;
    float gradientMax = 0.0f;  ///< largest |grad n| [1 / scene unit]
    float dispersionMax = 0.0f;          ///< most by which n differs at another visible wavelength
    float dispersedGradientMax = 0.0f;   ///< and grad n [1 / scene unit]
    bool boundary = false;     ///< part of the band of a boundary that changes n
    bool matter = false;       ///< absorbs, scatters or emits
    bool scatters = false;
    bool evenMatter = true;    ///< absorption, scattering, anisotropy and emission are constants
    bool opaque = false;       ///< opaque matter, however little
};

struct FieldPyramid {
    Lattice lattice;               ///< of the voxels
    DenseGrid<FieldBrick> bricks;  ///< brick (i, j, k) holds voxels from kBrickVoxels (i, j, k) on
};

FieldPyramid fieldPyramidOf(const Fields& fields);

/// Of fields that hold one object over nothing: where it has an area at all there is matter, and where its area varies uneven
/// matter, since it displaces what it lies over.
void boundArea(const DenseGrid<float>& area, FieldPyramid& pyramid);

/// Largest |grad n| [1 / scene unit] that counts as none. A ray that is not bent by a gradient g over a path s is off by
/// g s²/(2 n): over the domain's diagonal that may be `tolerance` voxels. Not below what rounding n to floats makes.
double negligibleGradient(const FieldPyramid& pyramid, double tolerance);

/// Distance from each brick to the nearest one that is an obstacle, in bricks along the axis on which it is largest
/// (Chebyshev); 0 in an obstacle, 255 at most. From any point of a brick with distance d > 0 the box that reaches d - 1
/// bricks beyond the brick on every side is free of obstacles. What is outside the lattice is none.
DenseGrid<unsigned char> clearanceOf(const FieldPyramid& pyramid,
                                     const std::function<bool(const FieldBrick&)>& isObstacle);

/// Turns a grid that is 0 at some places and 255 elsewhere into Chebyshev's distance to the nearest of those, 255 at most.
void spreadDistances(DenseGrid<unsigned char>& distance);

} // namespace eikonal
