#pragma once
// One object as it lies on the domain's lattice, before it is composed with the others.

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "common/lattice.h"
#include "common/scene.h"

namespace eikonal {

/// How much of each voxel an object takes. An empty grid: all of every voxel.
struct Extent {
    DenseGrid<float> index;              ///< smoothed coverage, for the refractive index
    DenseGrid<float> depth;              ///< of which the share of the voxel's cube follows, for everything else (common/depth.h)
    DenseGrid<unsigned char> boundary;   ///< 255 in the band where the object begins; empty: it has no boundary
    bool boundaryIsGiven = false;        ///< read off a given index: its contrast needs no further check
    bool knowsDistance = false;          ///< false: the depth is but a share, 0 to 1

    double indexAt(std::size_t offset) const { return index.empty() ? 1.0 : double(index.values[offset]); }
    double areaAt(std::size_t offset) const {
        return depth.empty() ? 1.0 : std::clamp(double(depth.values[offset]), 0.0, 1.0);
    }
};

/// An object's extent, and the grids of its volume by our names, resampled to the lattice.
struct ObjectLayer {
    const Object* object = nullptr;
    std::string label;  ///< for messages: "object 'ball'"
    Extent extent;
    std::map<std::string, DenseGrid<glm::vec3>> grids;
    bool changesIndex = true;
    std::vector<std::string> warnings;  ///< for the user, one line each

    const DenseGrid<glm::vec3>* grid(const std::string& name) const {
        const auto found = grids.find(name);
        return found == grids.end() ? nullptr : &found->second;
    }
};

/// An object in messages: by its name, or counted.
std::string labelOf(const Object& object, std::size_t index);

/// Throws badInput for meshes and volumes that cannot be used.
ObjectLayer layerOf(const Scene& scene, const Object& object, std::size_t index, const Lattice& lattice);

/// Distances [voxels], negative inside, to coverage, erfc(d / (sqrt2 b)) / 2, for the index, and to depth for the rest.
Extent extentFromDistance(const DenseGrid<float>& distanceVoxels, double smoothVoxels);

/// Beyond this many voxels from the surface only the side need be known: coverage is 0 or 1 to 3e-7.
double distanceBandVoxels(double smoothVoxels);

/// Fills the layer of an object that is a volume.
void fillVolumeLayer(const Scene& scene, const VolumeShape& shape, const Lattice& lattice, ObjectLayer& layer);

} // namespace eikonal
