#pragma once
// What lies on the grid: the optical constants of a scene, composed object after object (physics: docs/physics.md, 2).

#include "common/lattice.h"
#include "common/scene.h"

namespace eikonal {

/// Optical constants on the domain's lattice. A grid that the scene does not call for is empty.
struct Fields {
    Lattice lattice;
    DenseGrid<float> ior;              ///< refractive index n
    DenseGrid<glm::vec3> iorGradient;  ///< fourth-order central differences of n [1 / scene unit]; empty where n is uniform
    DenseGrid<float> iorSpline;        ///< of a cubic B-spline (splineCoefficients); empty: n and gradient interpolate linearly
    DenseGrid<float> cauchyB;            ///< Cauchy's B [µm²]: n is that at 0.5876 µm; empty: nothing disperses
    DenseGrid<glm::vec3> cauchyGradient;  ///< differences of it like those of n; present with cauchyB
    DenseGrid<unsigned char> interface;  ///< 255 inside the band of a boundary that changes n, 0 elsewhere; empty: none
    DenseGrid<glm::vec3> sigmaA;       ///< absorption [1 / scene unit]
    DenseGrid<glm::vec3> sigmaS;       ///< scattering [1 / scene unit]
    DenseGrid<float> anisotropy;       ///< Henyey-Greenstein g; present with sigmaS
    DenseGrid<glm::vec3> emission;     ///< radiance per scene unit
    DenseGrid<float> opaque;           ///< area coverage by opaque matter, 0 to 1
    DenseGrid<glm::vec3> albedo;       ///< of opaque surfaces; present with opaque
    float iorUniform = 1.0f;           ///< n where iorGradient is empty
};

/// The domain box of a scene cut into voxels: counts round up, the box extends past `max`.
Lattice latticeOf(const Domain& domain);

/// Composes the objects of a scene. Throws badInput for n <= 0 at any visible wavelength, values that are not finite, files
/// that cannot be read.
Fields composeFields(const Scene& scene);

/// Fourth-order central differences of n at voxel centres, one-sided orders falling to second at the faces.
DenseGrid<glm::vec3> gradientOf(const DenseGrid<float>& ior, double voxel);

} // namespace eikonal
