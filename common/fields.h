#pragma once
// What lies on the grid: the optical constants of a scene, composed object after object (physics: docs/physics.md, 2).

#include <memory>
#include <string>
#include <vector>

#include "common/lattice.h"
#include "common/scene.h"

namespace eikonal {

struct InsetGrids;  // common/insets.h

/// An object with a lattice of its own. It moves without its grids: they are in its own coordinates.
struct Inset {
    std::string label;  ///< for messages: "object 'ball'"
    std::shared_ptr<const InsetGrids> grids;
    glm::dmat4 worldFromLocal{1.0};  ///< a rotation, a shift and a scale
    double scale = 1.0;              ///< scene units in a unit of the object's own
};

/// Optical constants on the domain's lattice. A grid that the scene does not call for is empty.
struct Fields {
    Lattice lattice;
    DenseGrid<float> ior;              ///< refractive index n
    DenseGrid<glm::vec3> iorGradient;  ///< fourth-order central differences of n [1 / scene unit]; empty where n is uniform
    DenseGrid<float> cauchyB;            ///< Cauchy's B [µm²]: n is that at 0.5876 µm; empty: nothing disperses
    DenseGrid<glm::vec3> cauchyGradient;  ///< differences of it like those of n; present with cauchyB
    DenseGrid<unsigned char> interface;  ///< 255 inside the band of a boundary that changes n, 0 elsewhere; empty: none
    DenseGrid<glm::vec3> sigmaA;       ///< absorption [1 / scene unit]
    DenseGrid<glm::vec3> sigmaS;       ///< scattering [1 / scene unit]
    DenseGrid<float> anisotropy;       ///< Henyey-Greenstein g; present with sigmaS
    DenseGrid<glm::vec3> anisotropyByBand;  ///< g of each band where bands differ, and anisotropy is that farthest from 0;
                                            ///< empty: nowhere
    DenseGrid<glm::vec3> emission;     ///< radiance per scene unit
    DenseGrid<float> opaque;           ///< depth in opaque matter: the share of a voxel that it takes follows (common/depth.h)
    DenseGrid<glm::vec3> albedo;       ///< of opaque surfaces; present with opaque
    DenseGrid<glm::vec3> reflectionTint;  ///< factor on what boundaries reflect, in their bands; empty: 1 everywhere
    DenseGrid<float> roughness;        ///< of boundaries, in their bands, 0 smooth; empty: all are smooth
    float iorUniform = 1.0f;           ///< n where iorGradient is empty
    std::vector<Inset> insets;         ///< over all of this, in the scene's order: in images alone
    std::vector<std::string> warnings;  ///< of objects that are not what they seem, for the user, one line each
};

/// The domain box of a scene cut into voxels: counts round up, the box extends past `max`.
Lattice latticeOf(const Domain& domain);

/// Composes all objects of a scene on the domain's lattice, where light lives. Throws badInput for n <= 0 at any visible
/// wavelength, values that are not finite, files that cannot be read.
Fields composeFields(const Scene& scene);

/// The same as viewing rays see it: objects with a `resolution` are insets. Throws badInput besides for one too low for its
/// smoothing, for more than gpu::kMostInsets, and for an object without that comes after one with and may overlap it.
Fields composeImageFields(const Scene& scene);

/// Fourth-order central differences of n at voxel centres, one-sided orders falling to second at the faces.
DenseGrid<glm::vec3> gradientOf(const DenseGrid<float>& ior, double voxel);

} // namespace eikonal
