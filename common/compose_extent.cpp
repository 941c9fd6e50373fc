// Extents of shapes that have a formula and of meshes.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "common/compose_layer.h"
#include "common/error.h"
#include "common/mesh.h"
#include "common/shapes.h"
#include "common/voxelize.h"

namespace eikonal {
namespace {

std::string labelOf(const Object& object, std::size_t index) {
    return object.name.empty() ? fmt::format("object {}", index) : fmt::format("object '{}'", object.name);
}

template <class Function>
void forEachVoxel(const Lattice& lattice, const glm::dmat4& localFromWorld, const Function& function) {
    tbb::parallel_for(0, lattice.size.z, [&](int k) {
        for (int j = 0; j < lattice.size.y; ++j)
            for (int i = 0; i < lattice.size.x; ++i)
                function(i, j, k, glm::dvec3(localFromWorld * glm::dvec4(lattice.worldFromIndex({i, j, k}), 1.0)));
    });
}

DenseGrid<float> formulaDistance(const Object& object, const Lattice& lattice) {
    const ShapeDistance distance = signedDistanceOf(object.shape);
    DenseGrid<float> result(lattice.size, 0.0f);
    const double voxelsPerUnit = object.scale / lattice.voxel;  // of the object's own unit of length
    forEachVoxel(lattice, glm::inverse(object.worldFromLocal()), [&](int i, int j, int k, const glm::dvec3& local) {
        result.at(i, j, k) = float(voxelsPerUnit * distance(local));
    });
    return result;
}

DenseGrid<float> meshDistance(const Scene& scene, const Object& object, const Lattice& lattice, double bandVoxels) {
    const SolidMesh solid = loadSolidMesh(scene.resolve(std::get<MeshShape>(object.shape).file));
    DenseGrid<float> result = signedDistance(solid.mesh, lattice, object.worldFromLocal(), bandVoxels);
    for (float& distance : result.values)
        distance = float(distance / lattice.voxel);
    return result;
}

/// All of every voxel whose centre lies in the field's box, its faces included.
Extent fieldExtent(const Object& object, const Lattice& lattice) {
    const ShapeDistance distance = signedDistanceOf(object.shape);
    const double roundingSlack = 1e-9 * lattice.voxel / object.scale;
    Extent extent;
    extent.area = DenseGrid<float>(lattice.size, 0.0f);
    forEachVoxel(lattice, glm::inverse(object.worldFromLocal()), [&](int i, int j, int k, const glm::dvec3& local) {
        extent.area.at(i, j, k) = distance(local) <= roundingSlack ? 1.0f : 0.0f;
    });
    extent.index = extent.area;
    return extent;
}

} // namespace

double distanceBandVoxels(double smoothVoxels) { return std::max(6.0 * smoothVoxels, 3.0); }

Extent extentFromDistance(const DenseGrid<float>& distanceVoxels, double smoothVoxels) {
    // Coverage between 0.003 and 0.997: beyond it the index is that of the side, to 3 thousandths of the contrast.
    const double halfBand = smoothVoxels > 0.0 ? 2.75 * smoothVoxels : 1.5;
    const double farAway = distanceBandVoxels(smoothVoxels);
    const glm::ivec3 size = distanceVoxels.size;
    Extent extent{DenseGrid<float>(size, 0.0f), DenseGrid<float>(size, 0.0f), DenseGrid<unsigned char>(size, 0)};
    const std::size_t slab = std::size_t(size.x) * std::size_t(size.y);
    tbb::parallel_for(0, size.z, [&](int k) {
        for (std::size_t v = slab * std::size_t(k); v < slab * std::size_t(k + 1); ++v) {
            const double d = distanceVoxels.values[v];
            const double inside = d < 0.0 ? 1.0 : 0.0;
            const bool near = std::abs(d) < farAway;
            extent.index.values[v] = float(near ? coverageFromDistance(d, smoothVoxels, 1.0) : inside);
            extent.area.values[v] = float(near ? coverageFromDistance(d, 0.0, 1.0) : inside);
            extent.boundary.values[v] = std::abs(d) < halfBand ? 255 : 0;
        }
    });
    return extent;
}

ObjectLayer layerOf(const Scene& scene, const Object& object, std::size_t index, const Lattice& lattice) {
    ObjectLayer layer;
    layer.object = &object;
    layer.label = labelOf(object, index);
    layer.changesIndex = !object.opaque;  // no light gets inside: opaque matter leaves the index as it finds it
    const double smoothVoxels = object.smoothVoxels.value_or(scene.domain.smoothVoxels);
    if (const auto* volume = std::get_if<VolumeShape>(&object.shape)) {
        fillVolumeLayer(scene, *volume, lattice, layer);
    } else if (std::holds_alternative<FieldShape>(object.shape)) {
        layer.extent = fieldExtent(object, lattice);
        layer.changesIndex = layer.changesIndex && object.ior.given;
    } else if (std::holds_alternative<MeshShape>(object.shape)) {
        const DenseGrid<float> distance = meshDistance(scene, object, lattice, distanceBandVoxels(smoothVoxels));
        layer.extent = extentFromDistance(distance, smoothVoxels);
    } else {
        layer.extent = extentFromDistance(formulaDistance(object, lattice), smoothVoxels);
    }
    return layer;
}

} // namespace eikonal
