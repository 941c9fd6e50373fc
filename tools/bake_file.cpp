#include "tools/bake_file.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "common/error.h"
#include "common/scene_hash.h"
#include "common/scene_toml.h"
#include "common/spectrum.h"
#include "common/vdb_io.h"
#include "tools/lobe_grids.h"
#include "tools/program.h"
#include "tools/statistics_json.h"

namespace eikonal {

namespace {

std::string textOf(const Metadata& metadata, const std::string& key) {
    const auto entry = metadata.find(key);
    const bool isText = entry != metadata.end() && std::holds_alternative<std::string>(entry->second);
    return isText ? std::get<std::string>(entry->second) : std::string();
}

Lattice latticeOf(const VdbGrid& grid) {
    Lattice lattice;
    lattice.voxel = grid.voxelSize().x;
    lattice.size = grid.size();
    lattice.min = glm::dvec3(grid.worldFromIndex * glm::dvec4(-0.5, -0.5, -0.5, 1.0));
    return lattice;
}

std::string bandGridName(double wavelengthNm) { return fmt::format("irradiance_{}nm", std::lround(wavelengthNm)); }

/// The grids of the scene's bands; none if the file does not have all of them.
std::vector<BandIrradiance> bandsOf(const VdbFile& file, const Scene& scene, const glm::ivec3& size) {
    std::vector<BandIrradiance> bands;
    for (const SpectralBand& band : spectralBands(scene.accuracy.bands)) {
        const VdbGrid* grid = file.find(bandGridName(band.wavelengthNm()));
        if (grid == nullptr || !grid->isScalar() || grid->size() != size) {
            return {};
        }
        bands.push_back({band.wavelengthNm(), grid->scalar()});
    }
    return bands;
}

/// What tells the scene of a bake from this one, for a message.
std::string differenceFrom(const Scene& scene, const std::string& bakedScene, const std::string& bakeName) {
    try {
        const auto keys = differingKeys(scene, parseScene(bakedScene, bakeName + " (its scene)", scene.folder));
        return keys.empty() ? std::string("no key differs, but the contents of a file that the scene names do")
                            : fmt::format("these keys differ: {}", fmt::join(keys, ", "));
    } catch (const Error& error) {
        return fmt::format("and the scene that it holds cannot be read: {}", error.what());
    }
}

} // namespace

void writeBakeFile(const std::filesystem::path& path, const Scene& scene, const Fields& fields, const BakeResult& result,
                   std::optional<int> frame) {
    Metadata metadata{
        {"creator", std::string(kCreator)},
        {"version", std::string(kVersion)},
        {"scene", resolvedToml(scene)},
        {"scene_hash", sceneHash(scene, fields)},
        {"energy", energyJson(result.statistics).dump()},
        {"seconds", result.statistics.seconds.total},
        {"renderer", result.statistics.device},
    };
    if (frame) {
        metadata["frame"] = double(*frame);
    }
    std::vector<NamedGrid> grids{{.name = "irradiance", .values = &result.light.irradiance},
                                 {.name = "light_direction", .values = &result.light.lightDirection}};
    for (const BandIrradiance& band : result.light.bands) {
        grids.push_back({.name = bandGridName(band.wavelengthNm), .values = &band.irradiance});
    }
    const auto addEikonal = [&grids](const DenseGrid<float>& values, const std::string& name) {
        if (!values.empty()) {
            grids.push_back({.name = name, .values = &values, .background = glm::vec3(kUnreached)});
        }
    };
    addEikonal(result.light.eikonal, "eikonal");
    for (const NamedLight& part : result.parts) {
        grids.push_back({.name = "irradiance_" + part.name, .values = &part.light.irradiance});
        grids.push_back({.name = "light_direction_" + part.name, .values = &part.light.lightDirection});
        addEikonal(part.light.eikonal, "eikonal_" + part.name);
    }
    const LobeGrids lobes(result.light);
    const std::vector<NamedGrid> lobeGrids = lobes.named();
    grids.insert(grids.end(), lobeGrids.begin(), lobeGrids.end());
    writeVdb(path, result.light.lattice, grids, metadata);
}

BakedLight readBakeFile(const std::filesystem::path& path, const Scene& scene, const Fields& fields,
                        OtherScene otherScene) {
    const VdbFile file = readVdb(path);
    const VdbGrid& irradiance = vectorGrid(file, path, "irradiance");
    const VdbGrid& direction = vectorGrid(file, path, "light_direction");
    for (const VdbGrid& grid : file.grids) {
        if (const auto wrong = grid.whatIsNotFinite()) {
            throw badInput(fmt::format("{}: {}", path.string(), *wrong));
        }
    }
    if (irradiance.size() != direction.size()) {
        throw badInput(fmt::format("{}: expected 'irradiance' and 'light_direction' of one size, found two",
                                   path.string()));
    }
    if (otherScene == OtherScene::kRefuse && textOf(file.metadata, "scene_hash") != sceneHash(scene, fields)) {
        throw badInput(fmt::format("{}: expected a bake of {}, found one of another scene; {} (--force uses it anyway)",
                                   path.string(), scene.source,
                                   differenceFrom(scene, textOf(file.metadata, "scene"), path.string())));
    }
    return {.lattice = latticeOf(irradiance),
            .irradiance = irradiance.vector(),
            .lightDirection = direction.vector(),
            .lobes = readLobes(file, path, irradiance.size()),
            .bands = bandsOf(file, scene, irradiance.size())};
}

} // namespace eikonal
