// Objects that are volumes: grids by name, resampled; a level set or density is their shape.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/compose_layer.h"
#include "common/depth.h"
#include "common/distance_extension.h"
#include "common/error.h"
#include "common/gaussian_blur.h"
#include "common/given_index.h"
#include "common/vdb_io.h"
#include "common/volume_sampling.h"

namespace eikonal {
namespace {

Error volumeError(const ObjectLayer& layer, const std::string& what) {
    return badInput(fmt::format("{}: {}: {}", describe(layer.object->where), layer.label, what));
}

std::string gridList(const VdbFile& file) {
    std::string text;
    for (const VdbGrid& grid : file.grids)
        text += fmt::format("{}'{}' ({})", text.empty() ? "" : ", ", grid.name, grid.typeName);
    return text.empty() ? "no grids" : text;
}

/// Throws for a value that is no finite number, which nothing after this expects.
void requireFinite(const VdbGrid& grid, const ObjectLayer& layer) {
    if (const auto wrong = grid.whatIsNotFinite())
        throw volumeError(layer, *wrong);
}

/// The grid behind one of our names, or nullptr. Throws where the scene maps the name to a grid that is not there.
const VdbGrid* findGrid(const VdbFile& file, const VolumeShape& shape, const std::string& name, ObjectLayer& layer) {
    const auto mapped = shape.grids.find(name);
    const VdbGrid* grid = file.find(mapped == shape.grids.end() ? name : mapped->second);
    if (!grid && mapped != shape.grids.end())
        throw volumeError(layer, fmt::format("expected a grid '{}' for {} in {}, found {}", mapped->second, name,
                                             shape.file.string(), gridList(file)));
    const bool scalarOnly = name == "ior" || name == "anisotropy" || name == "opaque" || name == "density";
    if (grid && scalarOnly && !grid->isScalar())
        throw volumeError(layer, fmt::format("expected a float grid for {}, found '{}' ({})", name, grid->name,
                                             grid->typeName));
    return grid;
}

/// The grid that is the volume's shape: `density`, or whatever the file calls a level set or fog volume.
const VdbGrid* findShapeGrid(const VdbFile& file, const VolumeShape& shape, ObjectLayer& layer) {
    if (const VdbGrid* density = findGrid(file, shape, "density", layer))
        return density;
    const auto known = [&](const std::string& name) {
        return std::find(kVolumeGridNames.begin(), kVolumeGridNames.end(), name) != kVolumeGridNames.end();
    };
    for (const VdbGrid& grid : file.grids)
        if (grid.gridClass != VdbClass::kUnknown && grid.isScalar() && !known(grid.name))
            return &grid;
    return nullptr;
}

Extent levelSetExtent(const PlacedGrid& placed, double scale, double smoothVoxels, const Lattice& lattice) {
    DenseGrid<float> distance = firstComponent(resample(placed, lattice));
    const double voxelsPerUnit = scale / lattice.voxel;
    for (float& d : distance.values)
        d = float(d * voxelsPerUnit);
    extendDistance(distance, 0.99 * std::abs(double(placed.grid->background.x)) * voxelsPerUnit);
    return extentFromDistance(distance, smoothVoxels);
}

Extent fogExtent(const PlacedGrid& placed, const Lattice& lattice) {
    Extent extent;
    extent.depth = sharesOf(firstComponent(resample(placed, lattice)));
    extent.index = extent.depth;
    return extent;
}

/// Width b of the boundaries in a given index grid, as far as it is known [voxels of the domain]: what its writer noted,
/// and the blur added here; Gaussians add in squares.
double knownSmoothing(const VdbFile& file, const VdbGrid& grid, const Object& object, const Lattice& lattice) {
    double noted = 0.0;
    for (const Metadata* metadata : {&file.metadata, &grid.metadata})
        if (const auto found = metadata->find("eikonal_smooth_voxels"); found != metadata->end())
            if (const double* value = std::get_if<double>(&found->second))
                noted = *value;
    const glm::dvec3 edges = grid.voxelSize();
    const double voxelRatio = object.scale * std::max({edges.x, edges.y, edges.z}) / lattice.voxel;
    return std::hypot(noted * voxelRatio, object.smoothVoxels.value_or(0.0));
}

/// Voxels where a grid of the file holds matter are the object's, whatever its index there.
void includeMatterOfGrids(const ObjectLayer& layer, DenseGrid<float>& area) {
    for (const char* name : {"absorption", "scattering", "emission", "opaque"})
        if (const DenseGrid<glm::vec3>* grid = layer.grid(name))
            for (std::size_t v = 0; v < area.values.size(); ++v)
                if (grid->values[v] != glm::vec3(0.0f))
                    area.values[v] = 1.0f;
}

/// An index grid without a shape: it holds in all of its box; where it differs from its background there is matter.
Extent givenIndexExtent(const PlacedGrid& placed, const ObjectLayer& layer, double smoothVoxels,
                        const Lattice& lattice) {
    const DenseGrid<float> ior = firstComponent(*layer.grid("ior"));
    GivenIndex given = analyseGivenIndex(ior, smoothVoxels, double(placed.grid->background.x));
    includeMatterOfGrids(layer, given.matter);
    Extent extent{boxCoverage(placed, lattice), std::move(given.matter), std::move(given.boundary), true};
    for (std::size_t v = 0; v < extent.index.values.size(); ++v)
        extent.depth.values[v] *= extent.index.values[v];
    return extent;
}

/// Resamples every grid that the file has under one of our names, and returns one of them, or nullptr.
const VdbGrid* resampleGrids(const VdbFile& file, const VolumeShape& shape, const Lattice& lattice, ObjectLayer& layer) {
    const VdbGrid* any = nullptr;
    for (const std::string_view view : kVolumeGridNames) {
        const std::string name(view);
        const VdbGrid* grid = findGrid(file, shape, name, layer);
        if (!grid || name == "density")
            continue;
        any = grid;
        requireFinite(*grid, layer);
        layer.grids[name] = resample(PlacedGrid(*grid, layer.object->worldFromLocal(), lattice), lattice);
    }
    return any;
}

} // namespace

void fillVolumeLayer(const Scene& scene, const VolumeShape& shape, const Lattice& lattice, ObjectLayer& layer) {
    const Object& object = *layer.object;
    const VdbFile file = readVdb(scene.resolve(shape.file));
    const glm::dmat4 world = object.worldFromLocal();
    const VdbGrid* any = resampleGrids(file, shape, lattice, layer);
    const VdbGrid* shapeGrid = findShapeGrid(file, shape, layer);
    if (!any && !shapeGrid)
        throw volumeError(layer, fmt::format("expected grids named ior, absorption, scattering, density, ... or a level "
                                             "set in {}, found {}", shape.file.string(), gridList(file)));
    if (shapeGrid)
        requireFinite(*shapeGrid, layer);
    const VdbGrid* ior = findGrid(file, shape, "ior", layer);
    if (ior)
        layer.grids["ior"] = gaussianBlur(layer.grids["ior"], object.smoothVoxels.value_or(0.0));
    const bool isLevelSet = shapeGrid && shapeGrid->gridClass == VdbClass::kLevelSet;
    layer.changesIndex = !object.opaque && (ior || object.ior.given || isLevelSet);
    if (isLevelSet)
        layer.extent = levelSetExtent(PlacedGrid(*shapeGrid, world, lattice), object.scale,
                                      object.smoothVoxels.value_or(scene.domain.smoothVoxels), lattice);
    else if (shapeGrid)
        layer.extent = fogExtent(PlacedGrid(*shapeGrid, world, lattice), lattice);
    else if (ior)
        layer.extent = givenIndexExtent(PlacedGrid(*ior, world, lattice), layer,
                                        knownSmoothing(file, *ior, object, lattice), lattice);
    else
        layer.extent.index = layer.extent.depth = boxCoverage(PlacedGrid(*any, world, lattice), lattice);
}

} // namespace eikonal
