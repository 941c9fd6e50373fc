#include "common/reference/reference_field.h"

#include <array>

#include "common/cubic_spline.h"
#include "common/physics.h"

namespace eikonal::reference {

namespace {

/// Gradient [1 / scene unit] and value.
glm::dvec4 splineAt(const DenseGrid<float>& coefficients, const Lattice& lattice, const glm::dvec3& x) {
    const SplinePlace place = splinePlace(lattice, x);
    const std::array<glm::dvec4, 3> weight{f64::splineWeights(place.t.x), f64::splineWeights(place.t.y),
                                           f64::splineWeights(place.t.z)};
    const std::array<glm::dvec4, 3> slope{f64::splineSlopes(place.t.x), f64::splineSlopes(place.t.y),
                                          f64::splineSlopes(place.t.z)};
    glm::dvec4 sum(0.0);
    for (int c = 0; c < 4; ++c) {
        for (int b = 0; b < 4; ++b) {
            const float* row = &coefficients.at(place.first + glm::ivec3(0, b, c));
            const glm::dvec4 four(row[0], row[1], row[2], row[3]);
            const double value = glm::dot(four, weight[0]);
            sum += glm::dvec4(glm::dot(four, slope[0]) * weight[1][b] * weight[2][c], value * slope[1][b] * weight[2][c],
                              value * weight[1][b] * slope[2][c], value * weight[1][b] * weight[2][c]);
        }
    }
    return {glm::dvec3(sum) / lattice.voxel, sum.w};
}

} // namespace

GridField::GridField(const Fields& fields, Interpolation interpolation) : fields_(fields) {
    if (interpolation == Interpolation::kCubic && !fields.ior.empty()) {
        spline_ = std::make_shared<const DenseGrid<float>>(splineCoefficients(fields.ior));
    }
}

GridField GridField::at(double wavelengthMicrons) const {
    GridField result = *this;
    result.dispersionTerm_ = f64::dispersionTerm(wavelengthMicrons);
    return result;
}

glm::dvec4 GridField::index(const glm::dvec3& x) const {
    if (spline_) {
        return splineAt(*spline_, fields_.lattice, x);
    }
    return {trilinear(fields_.iorGradient, fields_.lattice, x), trilinear(fields_.ior, fields_.lattice, x)};
}

Optics GridField::optics(const glm::dvec3& x) const {
    if (fields_.iorGradient.empty()) {
        return {fields_.iorUniform, glm::dvec3(0.0)};
    }
    const glm::dvec4 found = index(x);
    const double n = found.w;
    const glm::dvec3 gradN(found);
    if (fields_.cauchyB.empty()) {
        return {n, gradN};
    }
    return {f64::dispersedIndex(n, trilinear(fields_.cauchyB, fields_.lattice, x), dispersionTerm_),
            f64::dispersedGradient(gradN, trilinear(fields_.cauchyGradient, fields_.lattice, x), dispersionTerm_)};
}

} // namespace eikonal::reference
