#pragma once
// Lobes of baked light as grids of a file: `lobe1_irradiance`, `lobe1_direction`, ... `lobe3_direction`. A voxel whose light is
// one lobe has it all in the first, so that the lobes of every voxel add up to its light.

#include <array>
#include <filesystem>
#include <vector>

#include "common/baked_light.h"
#include "common/vdb_io.h"

namespace eikonal {

/// Dense grids of the lobes, for the time of writing.
class LobeGrids {
public:
    /// Empty if the light has no lobes.
    explicit LobeGrids(const BakedLight& light);

    /// Refers to this object's grids.
    std::vector<NamedGrid> named() const;

private:
    struct Lobe {
        DenseGrid<glm::vec3> irradiance, direction;
    };
    std::vector<Lobe> lobes_;
};

/// The lobes in a file; empty if it has none. Throws badInput for grids of another type, or size than `size`.
LobeTable readLobes(const VdbFile& file, const std::filesystem::path& path, const glm::ivec3& size);

/// The vector grid of a file. Throws badInput if there is none of that name.
const VdbGrid& vectorGrid(const VdbFile& file, const std::filesystem::path& path, const std::string& name);

} // namespace eikonal
