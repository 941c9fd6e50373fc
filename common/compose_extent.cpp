// Extents of shapes that have a formula and of meshes.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "common/compose_layer.h"
#include "common/depth.h"
#include "common/error.h"
#include "common/mesh.h"
#include "common/shapes.h"
#include "common/voxelize.h"

namespace eikonal {
namespace {

constexpr int kBlock = 4;  // voxels

template <class Function>
void forEachVoxel(const Lattice& lattice, const glm::dmat4& localFromWorld, const Function& function) {
    tbb::parallel_for(0, lattice.size.z, [&](int k) {
        for (int j = 0; j < lattice.size.y; ++j)
            for (int i = 0; i < lattice.size.x; ++i)
                function(i, j, k, glm::dvec3(localFromWorld * glm::dvec4(lattice.worldFromIndex({i, j, k}), 1.0)));
    });
}

/// Distances at the voxels of one block [voxels]. Distance changes by no more than the way that one goes: a block whose
/// centre is far enough from the surface needs no more than its side and takes the centre's.
void fillBlock(const ShapeDistance& distance, double voxelsPerUnit, const glm::dmat4& localFromWorld,
               const Lattice& lattice, const glm::ivec3& low, double bandVoxels, DenseGrid<float>& result) {
    const glm::ivec3 high = glm::min(low + kBlock, lattice.size);
    const auto distanceAt = [&](const glm::dvec3& index) {
        const glm::dvec3 world = lattice.min + lattice.voxel * (index + 0.5);
        return voxelsPerUnit * distance(glm::dvec3(localFromWorld * glm::dvec4(world, 1.0)));
    };
    const double reach = 0.5 * std::sqrt(3.0) * kBlock;
    const double atCentre = distanceAt(0.5 * glm::dvec3(low + high - 1));
    const bool far = std::abs(atCentre) > bandVoxels + reach;
    for (int k = low.z; k < high.z; ++k)
        for (int j = low.y; j < high.y; ++j)
            for (int i = low.x; i < high.x; ++i)
                result.at(i, j, k) = float(far ? atCentre : distanceAt(glm::dvec3(i, j, k)));
}

DenseGrid<float> formulaDistance(const Object& object, const Lattice& lattice, double bandVoxels) {
    const ShapeDistance distance = signedDistanceOf(object.shape);
    const double voxelsPerUnit = object.scale / lattice.voxel;  // of the object's own unit of length
    const glm::dmat4 localFromWorld = glm::inverse(object.worldFromLocal());
    DenseGrid<float> result(lattice.size, 0.0f);
    tbb::parallel_for(0, (lattice.size.z + kBlock - 1) / kBlock, [&](int slab) {
        for (int j = 0; j < lattice.size.y; j += kBlock)
            for (int i = 0; i < lattice.size.x; i += kBlock)
                fillBlock(distance, voxelsPerUnit, localFromWorld, lattice, {i, j, slab * kBlock}, bandVoxels, result);
    });
    return result;
}

bool isInside(const Bounds& box, const Lattice& lattice, const glm::dmat4& worldFromLocal) {
    bool inside = true;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::dvec3 world(worldFromLocal * glm::dvec4(glm::mix(box.min, box.max, side), 1.0));
        inside = inside && glm::all(glm::greaterThanEqual(world, lattice.min)) &&
                 glm::all(glm::lessThanEqual(world, lattice.min + lattice.extent()));
    }
    return inside;
}

/// Distances to a mesh [voxels], and what is to be said of it.
DenseGrid<float> meshDistance(const Scene& scene, const Object& object, const Lattice& lattice, double bandVoxels,
                              std::vector<std::string>& warnings) {
    const SolidMesh solid = loadSolidMesh(scene.resolve(std::get<MeshShape>(object.shape).file));
    warnings = solid.report.messages;
    const glm::dmat4 worldFromMesh = object.worldFromLocal();
    DenseGrid<float> result = signedDistance(solid.mesh, lattice, worldFromMesh, bandVoxels);
    if (isInside(boundsOf(solid.mesh), lattice, worldFromMesh)) {
        const double volume = meshVolume(solid.mesh) * std::abs(glm::determinant(glm::dmat3(worldFromMesh)));
        if (const auto warning = volumeWarning(voxelizedVolume(result, lattice.voxel), volume))
            warnings.push_back(*warning);
    }
    for (float& distance : result.values)
        distance = float(distance / lattice.voxel);
    return result;
}

/// All of every voxel whose centre lies in the field's box, its faces included.
Extent fieldExtent(const Object& object, const Lattice& lattice) {
    const ShapeDistance distance = signedDistanceOf(object.shape);
    const double roundingSlack = 1e-9 * lattice.voxel / object.scale;
    Extent extent;
    extent.depth = DenseGrid<float>(lattice.size, 0.0f);
    forEachVoxel(lattice, glm::inverse(object.worldFromLocal()), [&](int i, int j, int k, const glm::dvec3& local) {
        extent.depth.at(i, j, k) = distance(local) <= roundingSlack ? 1.0f : 0.0f;
    });
    extent.index = extent.depth;
    return extent;
}

} // namespace

std::string labelOf(const Object& object, std::size_t index) {
    return object.name.empty() ? fmt::format("object {}", index) : fmt::format("object '{}'", object.name);
}

double distanceBandVoxels(double smoothVoxels) { return std::max(5.0 * smoothVoxels, 3.0); }

Extent extentFromDistance(const DenseGrid<float>& distanceVoxels, double smoothVoxels) {
    // Coverage between 0.003 and 0.997: beyond it the index is that of the side, to 3 thousandths of the contrast.
    const double halfBand = smoothVoxels > 0.0 ? 2.75 * smoothVoxels : 1.5;
    const double farAway = distanceBandVoxels(smoothVoxels);
    const glm::ivec3 size = distanceVoxels.size;
    Extent extent{DenseGrid<float>(size, 0.0f), DenseGrid<float>(size, 0.0f), DenseGrid<unsigned char>(size, 0)};
    extent.knowsDistance = true;
    const std::size_t slab = std::size_t(size.x) * std::size_t(size.y);
    tbb::parallel_for(0, size.z, [&](int k) {
        for (std::size_t v = slab * std::size_t(k); v < slab * std::size_t(k + 1); ++v) {
            const double d = distanceVoxels.values[v];
            const double inside = d < 0.0 ? 1.0 : 0.0;
            const bool near = std::abs(d) < farAway;
            extent.index.values[v] = float(near ? coverageFromDistance(d, smoothVoxels, 1.0) : inside);
            extent.depth.values[v] = float(depthFromDistance(d));
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
        const DenseGrid<float> distance = meshDistance(scene, object, lattice, distanceBandVoxels(smoothVoxels), layer.warnings);
        layer.extent = extentFromDistance(distance, smoothVoxels);
    } else {
        const DenseGrid<float> distance = formulaDistance(object, lattice, distanceBandVoxels(smoothVoxels));
        layer.extent = extentFromDistance(distance, smoothVoxels);
    }
    return layer;
}

} // namespace eikonal
