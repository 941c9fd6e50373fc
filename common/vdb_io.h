#pragma once
// OpenVDB files in and out, as dense grids. No OpenVDB type leaves vdb_io.cpp.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>

#include "common/lattice.h"

namespace eikonal {

enum class VdbClass { kUnknown, kFogVolume, kLevelSet };

using Metadata = std::map<std::string, std::variant<std::string, double>>;

/// One grid of a file, dense over its active bounding box.
struct VdbGrid {
    std::string name;
    VdbClass gridClass = VdbClass::kUnknown;
    std::string typeName;                                       ///< OpenVDB's: "float", "vec3s", ...
    std::variant<DenseGrid<float>, DenseGrid<glm::vec3>> values;  ///< inactive voxels hold their stored value
    glm::ivec3 indexMin{0};                                     ///< lower corner of the active box in the file
    glm::vec3 background{0.0f};                                 ///< .x for scalar grids
    glm::dmat4 worldFromIndex{1.0};                             ///< of `values`; index (i, j, k) is a voxel's centre
    Metadata metadata;                                          ///< strings and numbers of this grid

    bool isScalar() const { return std::holds_alternative<DenseGrid<float>>(values); }
    const DenseGrid<float>& scalar() const { return std::get<DenseGrid<float>>(values); }
    const DenseGrid<glm::vec3>& vector() const { return std::get<DenseGrid<glm::vec3>>(values); }
    glm::ivec3 size() const;
    /// Edges of a voxel in world space along the three index axes [scene units].
    glm::dvec3 voxelSize() const;
    /// What was expected and found where the first value is no finite number; nothing where all are.
    std::optional<std::string> whatIsNotFinite() const;
};

struct VdbFile {
    std::vector<VdbGrid> grids;
    Metadata metadata;                      ///< of the file
    std::vector<std::string> skippedGrids;  ///< "name (type)" of grids that are neither scalar nor 3-vectors

    /// The grid of that name, or nullptr.
    const VdbGrid* find(const std::string& name) const;
};

/// Reads a file; half, double and integer scalars and double vectors become float. Damaged files are found in a child
/// process with limits on memory and time, before this one touches them. Throws badInput for files that are missing,
/// empty, truncated or not VDB, and for grids too large to hold densely.
VdbFile readVdb(const std::filesystem::path& path);

/// A grid to be written; size as the lattice's.
struct NamedGrid {
    std::string name;
    std::variant<const DenseGrid<float>*, const DenseGrid<glm::vec3>*> values;
    glm::vec3 background{0.0f};  ///< .x for scalar grids
    VdbClass gridClass = VdbClass::kUnknown;
};

/// Writes grids on a lattice: active everywhere, also where a value equals the background, index i at the voxel's centre,
/// blosc compression where the library has it. Throws failure for an unwritable folder or a full disk.
void writeVdb(const std::filesystem::path& path, const Lattice& lattice, const std::vector<NamedGrid>& grids,
              const Metadata& metadata);

/// For `info`: {"file", "metadata", "grids": [{"name", "type", "class", "size", "active_box", "active_voxels",
/// "min", "max", "background", "voxel_size", "world_min", "world_max", "transform", "metadata"}]}. Throws as readVdb.
nlohmann::json vdbSummary(const std::filesystem::path& path);

} // namespace eikonal
