#include "common/reference/reference_field.h"

#include "common/physics.h"

namespace eikonal::reference {

Optics GridField::optics(const glm::dvec3& x) const {
    if (fields_.iorGradient.empty()) {
        return {fields_.iorUniform, glm::dvec3(0.0)};
    }
    const double n = trilinear(fields_.ior, fields_.lattice, x);
    const glm::dvec3 gradN = trilinear(fields_.iorGradient, fields_.lattice, x);
    if (fields_.cauchyB.empty()) {
        return {n, gradN};
    }
    return {f64::dispersedIndex(n, trilinear(fields_.cauchyB, fields_.lattice, x), dispersionTerm_),
            f64::dispersedGradient(gradN, trilinear(fields_.cauchyGradient, fields_.lattice, x), dispersionTerm_)};
}

} // namespace eikonal::reference
