#pragma once
// Scenes made in memory: index fields from formulas, matter from boxes, surroundings of one colour.

#include <functional>

#include <gtest/gtest.h>

#include "common/effects.h"
#include "common/fields.h"
#include "common/gpu/context.h"

namespace eikonal::test {

/// The context that all tests of the process share: one is current at a time.
const gpu::Context& sharedContext();

Lattice cube(int resolution, double halfEdge);

template <class Visit>
void forEachVoxel(const Lattice& lattice, const Visit& visit) {
    for (int k = 0; k < lattice.size.z; ++k) {
        for (int j = 0; j < lattice.size.y; ++j) {
            for (int i = 0; i < lattice.size.x; ++i) visit(glm::ivec3(i, j, k));
        }
    }
}

/// Samples of n at voxel centres and their fourth-order differences; no interfaces, no matter.
Fields indexFields(const Lattice& lattice, const std::function<double(const glm::dvec3&)>& n);

/// Nothing but a lattice, in vacuum or in a uniform index.
Fields uniformFields(const Lattice& lattice, double n = 1.0);

/// A smoothed sphere about the origin: n = 1 + (index - 1) erfc((r - radius)/(sqrt(2) width))/2, with its interface band.
Fields sphereFields(const Lattice& lattice, double radius, double index, double width);

/// The fields with a Cauchy's B [µm²] that goes with the refractivity n - 1, as that of one glass does: `cauchyB` where n is
/// `index`.
Fields dispersing(Fields fields, double cauchyB, double index);

/// A value inside a box by the share of each voxel that it covers.
DenseGrid<glm::vec3> boxGrid(const Lattice& lattice, const glm::dvec3& min, const glm::dvec3& max,
                             const glm::vec3& value);

/// The share of each voxel that a box covers.
DenseGrid<float> boxCoverage(const Lattice& lattice, const glm::dvec3& min, const glm::dvec3& max);

/// The share of a voxel that a sphere about the origin covers, as if its surface were flat.
double sphereCoverage(const Lattice& lattice, const glm::ivec3& voxel, double radius);

/// Scene under one colour, seen by a camera on +Z that looks at the origin; `size` pixels square.
Scene plainScene(const glm::dvec3& surroundings, double cameraDistance, double fov, int size);

EffectSet effectsOf(const Scene& scene, const Fields& fields);

} // namespace eikonal::test
