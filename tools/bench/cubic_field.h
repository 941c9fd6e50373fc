#pragma once
// Prefiltered cubic B-splines of samples on a lattice, with the gradient of the spline itself.
// P. Thévenaz, T. Blu, M. Unser, Interpolation Revisited, IEEE Transactions on Medical Imaging 19 (2000).

#include "common/reference/reference_field.h"

namespace eikonal::bench {

class CubicField {
public:
    /// The spline that goes through the samples, mirrored at the faces.
    CubicField(const DenseGrid<float>& samples, const Lattice& lattice);

    reference::Optics optics(const glm::dvec3& x) const;

private:
    Lattice lattice_;
    DenseGrid<float> coefficients_;
};

} // namespace eikonal::bench
