#pragma once
// The cubic B-spline through samples on a lattice (shaders/physics/spline.glsl has its weights).

#include "common/lattice.h"

namespace eikonal {

/// Coefficients of the spline through `samples`, one more all round; a single sample along an axis counts twice. At the faces
/// its third derivative does not jump at the outermost sample but one, so that cubics are exact up to the faces; with fewer
/// than four samples along an axis its second derivative ends at 0.
DenseGrid<float> splineCoefficients(const DenseGrid<float>& samples);

/// How much of the curvature of `samples` is kinks, which splines ring at: the squares of fourth differences over four times
/// those of second ones, summed over all axes. 1 for kinks, on the average over where they lie between voxels; 5/2 for steps;
/// 0.07 to 0.13 for boundaries smoothed over 1.5 voxels; 0 where nothing is curved.
double kinkShare(const DenseGrid<float>& samples);

/// Where a position lies among the coefficients: the first of four along each axis, and how far between the second and third.
struct SplinePlace {
    glm::ivec3 first;
    glm::dvec3 t;
};

/// Positions beyond the outermost samples count as on them, as with linear interpolation.
SplinePlace splinePlace(const Lattice& lattice, const glm::dvec3& x);

} // namespace eikonal
