#include "common/vdb_parse.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include "common/error.h"

namespace eikonal {
namespace {

using nlohmann::json;

constexpr std::int64_t kMaxVoxels = std::int64_t(1) << 31;

struct OpenedFile {
    openvdb::GridPtrVecPtr grids;
    openvdb::MetaMap::Ptr metadata;
};

OpenedFile openFile(const std::filesystem::path& path) {
    openvdb::initialize();
    try {
        openvdb::io::File file(path.string());
        file.open(false);  // delayed loading crashes on damaged files
        OpenedFile opened{file.getGrids(), file.getMetadata()};
        if (!opened.grids || opened.grids->empty())
            throw badInput(fmt::format("{}: expected a VDB file with grids, found none: empty or truncated", path.string()));
        return opened;
    } catch (const openvdb::Exception& e) {
        throw badInput(fmt::format("{}: expected a VDB file, found something else or a damaged one ({})", path.string(),
                                   e.what()));
    }
}

Metadata metadataOf(const openvdb::MetaMap& map) {
    Metadata result;
    for (auto it = map.beginMeta(); it != map.endMeta(); ++it) {
        const openvdb::Metadata& value = *it->second;
        const std::string type = value.typeName();
        const bool number = type == "double" || type == "float" || type == "int32" || type == "int64";
        double parsed = 0.0;
        try {
            parsed = number ? std::stod(value.str()) : 0.0;
        } catch (const std::exception&) {
            parsed = std::numeric_limits<double>::quiet_NaN();
        }
        if (number && std::isfinite(parsed))
            result[it->first] = parsed;
        else
            result[it->first] = value.str();
    }
    return result;
}

VdbClass classOf(const openvdb::GridBase& grid) {
    switch (grid.getGridClass()) {
    case openvdb::GRID_LEVEL_SET:
        return VdbClass::kLevelSet;
    case openvdb::GRID_FOG_VOLUME:
        return VdbClass::kFogVolume;
    default:
        return VdbClass::kUnknown;
    }
}

std::string placeOf(const std::filesystem::path& path, const openvdb::GridBase& grid) {
    return fmt::format("{}: grid '{}'", path.string(), grid.getName());
}

/// The affine map of a grid, from index (0, 0, 0) of the file.
glm::dmat4 worldFromFileIndex(const std::filesystem::path& path, const openvdb::GridBase& grid) {
    if (!grid.transform().isLinear())
        throw badInput(fmt::format("{}: expected an affine transform, found a {}", placeOf(path, grid),
                                   grid.transform().mapType()));
    glm::dmat4 result(1.0);
    const openvdb::Mat4R matrix = grid.transform().baseMap()->getAffineMap()->getMat4();
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            result[row][column] = matrix(row, column);  // OpenVDB multiplies row vectors from the left
    bool finite = true;
    for (int i = 0; i < 16; ++i)
        finite = finite && std::isfinite(result[i / 4][i % 4]);
    if (!finite || std::abs(glm::determinant(glm::dmat3(result))) < std::numeric_limits<double>::min())
        throw badInput(fmt::format("{}: expected an invertible transform, found none: damaged file", placeOf(path, grid)));
    return result;
}

template <class Value>
auto toFloat(const Value& value) {
    if constexpr (openvdb::VecTraits<Value>::IsVec)
        return glm::vec3(float(value[0]), float(value[1]), float(value[2]));
    else
        return float(value);
}

openvdb::CoordBBox activeBox(const std::filesystem::path& path, const openvdb::GridBase& grid) {
    const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
    if (box.empty())
        return box;
    std::int64_t count = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t edge = std::int64_t(box.max()[axis]) - box.min()[axis] + 1;
        count = edge > kMaxVoxels || count * edge > kMaxVoxels ? kMaxVoxels + 1 : count * edge;
    }
    if (count > kMaxVoxels)
        throw badInput(fmt::format("{}: its active box from ({}, {}, {}) to ({}, {}, {}) has more than 2^31 voxels: "
                                   "too large to hold densely",
                                   placeOf(path, grid), box.min().x(), box.min().y(), box.min().z(), box.max().x(),
                                   box.max().y(), box.max().z()));
    return box;
}

template <class Grid>
void fillValues(const std::filesystem::path& path, const Grid& grid, VdbGrid& result) {
    using Value = decltype(toFloat(grid.background()));
    const openvdb::CoordBBox box = activeBox(path, grid);
    result.background = glm::vec3(toFloat(grid.background()));
    DenseGrid<Value> dense;
    if (!box.empty()) {
        result.indexMin = {box.min().x(), box.min().y(), box.min().z()};
        dense = DenseGrid<Value>(glm::ivec3(box.dim().x(), box.dim().y(), box.dim().z()), Value(0.0f));
        auto accessor = grid.getConstAccessor();
        std::size_t next = 0;
        for (int k = box.min().z(); k <= box.max().z(); ++k)
            for (int j = box.min().y(); j <= box.max().y(); ++j)
                for (int i = box.min().x(); i <= box.max().x(); ++i)
                    dense.values[next++] = toFloat(accessor.getValue(openvdb::Coord(i, j, k)));
    }
    result.values = std::move(dense);
}

/// Calls visit(grid) with the concrete type; false for types that are neither scalars nor 3-vectors.
template <class Visit>
bool withType(const openvdb::GridBase& base, Visit&& visit) {
    using Grids = openvdb::TypeList<openvdb::FloatGrid, openvdb::DoubleGrid, openvdb::Int32Grid, openvdb::Int64Grid,
                                    openvdb::BoolGrid, openvdb::Vec3SGrid, openvdb::Vec3DGrid, openvdb::Vec3IGrid>;
    return base.apply<Grids>(visit);
}

VdbGrid gridFrom(const std::filesystem::path& path, const openvdb::GridBase& base) {
    VdbGrid result;
    result.name = base.getName();
    result.gridClass = classOf(base);
    result.typeName = base.valueType();
    result.metadata = metadataOf(base);
    withType(base, [&](const auto& grid) { fillValues(path, grid, result); });
    const glm::dmat4 matrix = worldFromFileIndex(path, base);
    glm::dmat4 offset(1.0);
    offset[3] = glm::dvec4(glm::dvec3(result.indexMin), 1.0);
    result.worldFromIndex = matrix * offset;
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(result.background[i]))
            throw badInput(fmt::format("{}: its background value is not finite", placeOf(path, base)));
    return result;
}

json listOf(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
json listOf(const openvdb::Coord& v) { return {v.x(), v.y(), v.z()}; }

/// Smallest and largest active value; by component for vectors.
template <class Grid>
json rangeOf(const Grid& grid) {
    glm::dvec3 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
    std::uint64_t notFinite = 0;
    for (auto it = grid.cbeginValueOn(); it; ++it) {
        const glm::dvec3 value(toFloat(*it));
        if (!std::isfinite(value.x + value.y + value.z)) {
            ++notFinite;
            continue;
        }
        low = glm::min(low, value);
        high = glm::max(high, value);
    }
    json result = {{"not_finite", notFinite}, {"min", nullptr}, {"max", nullptr}};
    if (low.x <= high.x) {
        constexpr bool kVector = openvdb::VecTraits<typename Grid::ValueType>::IsVec;
        result["min"] = kVector ? listOf(low) : json(low.x);
        result["max"] = kVector ? listOf(high) : json(high.x);
    }
    const glm::dvec3 background(toFloat(grid.background()));
    result["background"] = openvdb::VecTraits<typename Grid::ValueType>::IsVec ? listOf(background) : json(background.x);
    return result;
}

json metadataJson(const openvdb::MetaMap& map) {
    json result = json::object();
    for (const auto& [key, value] : metadataOf(map))
        std::visit([&, &name = key](const auto& v) { result[name] = v; }, value);
    return result;
}

void addPlacement(json& entry, const glm::dmat4& worldFromIndex, const openvdb::CoordBBox& box) {
    json rows = json::array();
    for (int row = 0; row < 4; ++row)
        rows.push_back({worldFromIndex[0][row], worldFromIndex[1][row], worldFromIndex[2][row], worldFromIndex[3][row]});
    entry["transform"] = rows;
    entry["voxel_size"] = listOf(glm::dvec3(glm::length(glm::dvec3(worldFromIndex[0])),
                                            glm::length(glm::dvec3(worldFromIndex[1])),
                                            glm::length(glm::dvec3(worldFromIndex[2]))));
    if (box.empty())
        return;
    glm::dvec3 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
    for (int corner = 0; corner < 8; ++corner) {
        glm::dvec4 index(0.0, 0.0, 0.0, 1.0);
        for (int axis = 0; axis < 3; ++axis)
            index[axis] = (corner >> axis & 1) ? box.max()[axis] + 0.5 : box.min()[axis] - 0.5;
        const glm::dvec3 world(worldFromIndex * index);
        low = glm::min(low, world);
        high = glm::max(high, world);
    }
    entry["world_min"] = listOf(low);
    entry["world_max"] = listOf(high);
}

json summaryOf(const std::filesystem::path& path, const openvdb::GridBase& base) {
    const openvdb::CoordBBox box = base.evalActiveVoxelBoundingBox();
    const openvdb::Coord size = box.empty() ? openvdb::Coord(0) : box.dim();
    json entry = {{"name", base.getName()},
                  {"type", base.valueType()},
                  {"class", openvdb::GridBase::gridClassToString(base.getGridClass())},
                  {"size", listOf(size)},
                  {"active_voxels", base.activeVoxelCount()},
                  {"active_box", nullptr},
                  {"metadata", metadataJson(base)}};
    if (!box.empty())
        entry["active_box"] = {listOf(box.min()), listOf(box.max())};
    withType(base, [&](const auto& grid) { entry.update(rangeOf(grid)); });
    if (base.transform().isLinear())
        addPlacement(entry, worldFromFileIndex(path, base), box);
    return entry;
}

} // namespace

VdbFile parseVdb(const std::filesystem::path& path) {
    const OpenedFile opened = openFile(path);
    VdbFile result;
    result.metadata = metadataOf(*opened.metadata);
    for (openvdb::GridBase::Ptr& grid : *opened.grids) {
        if (withType(*grid, [](const auto&) {}))
            result.grids.push_back(gridFrom(path, *grid));
        else
            result.skippedGrids.push_back(fmt::format("{} ({})", grid->getName(), grid->valueType()));
        grid.reset();  // dense and sparse together would need the memory twice
    }
    return result;
}

json summarizeVdb(const std::filesystem::path& path) {
    const OpenedFile opened = openFile(path);
    json result = {{"file", path.string()}, {"metadata", metadataJson(*opened.metadata)}, {"grids", json::array()}};
    for (const openvdb::GridBase::Ptr& grid : *opened.grids)
        result["grids"].push_back(summaryOf(path, *grid));
    return result;
}

} // namespace eikonal
