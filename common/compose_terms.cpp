#include "common/compose_terms.h"

namespace eikonal {

void requireAllowed(const ObjectLayer& layer, const Term& term, const Lattice& lattice, std::size_t voxel) {
    const std::size_t nx = std::size_t(lattice.size.x), ny = std::size_t(lattice.size.y);
    const glm::dvec3 world = lattice.worldFromIndex({int(voxel % nx), int(voxel / nx % ny), int(voxel / (nx * ny))});
    const glm::dvec3 local(glm::inverse(layer.object->worldFromLocal()) * glm::dvec4(world, 1.0));
    const glm::dvec3 value = TermValue(layer, term).at(local, voxel);
    if (term.allows(value))
        return;
    const bool same = value.x == value.y && value.y == value.z;
    const bool scalar = same || !std::isfinite(value.x);
    const std::string found =
        scalar ? fmt::format("{:g}", value.x) : fmt::format("[{:g}, {:g}, {:g}]", value.x, value.y, value.z);
    const SourcePosition& where = term.quantity->where.file.empty() ? layer.object->where : term.quantity->where;
    const std::string place = describe(where);
    throw badInput(fmt::format("{}{}{}: {} is {} at ({:g}, {:g}, {:g}), expected a finite value {}", place,
                               place.empty() ? "" : ": ", layer.label, term.name, found, world.x, world.y, world.z,
                               term.expected()));
}

} // namespace eikonal
