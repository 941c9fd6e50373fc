// From objects to optical constants on the lattice (docs/physics.md, section 2).

#include "common/fields.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/compose_layer.h"
#include "common/compose_matter.h"
#include "common/error.h"
#include "common/insets.h"
#include "common/spectral_fields.h"

namespace eikonal {
namespace {

/// What fills the domain before any object: an object without end.
Object backgroundOf(const Scene& scene) {
    Object background;
    background.ior = scene.domain.ior;
    background.absorption = scene.medium.absorption;
    background.scattering = scene.medium.scattering;
    background.anisotropy = scene.medium.anisotropy;
    background.where.file = scene.source;
    return background;
}

void warnOf(const ObjectLayer& layer, Fields& fields) {
    for (const std::string& message : layer.warnings)
        fields.warnings.push_back(fmt::format("{}: {}", layer.label, message));
    const std::vector<float>& depth = layer.extent.depth.values;
    if (!depth.empty() && std::all_of(depth.begin(), depth.end(), [](float value) { return value <= 0.0f; }))
        fields.warnings.push_back(fmt::format("{}: no voxel of the domain has any of it: it lies outside, or is too small", layer.label));
}

/// The objects of a scene that `isIncluded`.
template <class IsIncluded>
Fields composedOnDomain(const Scene& scene, const IsIncluded& isIncluded) {
    Fields fields;
    fields.lattice = latticeOf(scene.domain);
    fields.ior = DenseGrid<float>(fields.lattice.size, 1.0f);
    fields.interface = DenseGrid<unsigned char>(fields.lattice.size, 0);
    const Object background = backgroundOf(scene);
    composeLayer(ObjectLayer{.object = &background, .label = "domain", .extent = {}, .grids = {}}, fields);
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (isIncluded(scene.objects[i])) {
            const ObjectLayer layer = layerOf(scene, scene.objects[i], i, fields.lattice);
            warnOf(layer, fields);
            composeLayer(layer, fields);
        }
    finishFields(fields);
    requireIndexAt(fields, kLongestVisibleMicrons, scene.source);
    return fields;
}

} // namespace

Lattice latticeOf(const Domain& domain) {
    const glm::dvec3 extent = domain.max - domain.min;
    Lattice lattice;
    lattice.min = domain.min;
    lattice.voxel = std::max({extent.x, extent.y, extent.z}) / domain.resolution;
    constexpr double kRounding = 1e-6;  // voxels: a whole number of voxels stays that number
    lattice.size = glm::max(glm::ivec3(glm::ceil(extent / lattice.voxel - kRounding)), glm::ivec3(1));
    constexpr double kMostVoxels = 2147483648.0;  // indices on the GPU are 32-bit
    if (double(lattice.count()) >= kMostVoxels)
        throw badInput(fmt::format("domain: expected fewer than 2^31 voxels, found {} x {} x {}; lower the resolution",
                                   lattice.size.x, lattice.size.y, lattice.size.z));
    return lattice;
}

Fields composeFields(const Scene& scene) {
    return composedOnDomain(scene, [](const Object&) { return true; });
}

Fields composeImageFields(const Scene& scene) {
    requireInsetsComeLast(scene);
    Fields fields = composedOnDomain(scene, [](const Object& object) { return !object.resolution; });
    fields.insets = composeInsets(scene);
    return fields;
}

} // namespace eikonal
