#include "tools/bench/sampled_field.h"

namespace eikonal::bench {

Lattice cubeLattice(int resolution, double halfEdge) {
    return {glm::dvec3(-halfEdge), 2.0 * halfEdge / resolution, glm::ivec3(resolution)};
}

Fields sampledField(const Lattice& lattice, const std::function<double(const glm::dvec3&)>& n) {
    Fields fields;
    fields.lattice = lattice;
    fields.ior = DenseGrid<float>(lattice.size, 1.0f);
    forEachVoxel(lattice, [&](const glm::ivec3& v) { fields.ior.at(v) = float(n(lattice.worldFromIndex(v))); });
    fields.iorGradient = gradientOf(fields.ior, lattice.voxel);
    return fields;
}

} // namespace eikonal::bench
