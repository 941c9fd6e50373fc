#include "common/vdb_transfer.h"

#include <cstdint>

#include <nlohmann/json.hpp>

#include "common/error.h"

namespace eikonal {
namespace {

using nlohmann::json;

constexpr std::uint64_t kMaxHeaderBytes = 64u << 20;
constexpr std::int64_t kMaxVoxels = std::int64_t(1) << 31;

void put(std::FILE* stream, const void* data, std::size_t bytes) {
    if (bytes > 0 && std::fwrite(data, 1, bytes, stream) != bytes)
        throw failure("the program that asked for a VDB file is gone");
}

json jsonOf(const Metadata& metadata) {
    json result = json::object();
    for (const auto& [key, value] : metadata)
        std::visit([&, &name = key](const auto& v) { result[name] = v; }, value);
    return result;
}

Metadata metadataFrom(const json& object) {
    Metadata result;
    for (const auto& [key, value] : object.items()) {
        if (value.is_string())
            result[key] = value.get<std::string>();
        else if (value.is_number())
            result[key] = value.get<double>();
    }
    return result;
}

json headerOf(const VdbGrid& grid) {
    const glm::ivec3 size = grid.size();
    json matrix = json::array();
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            matrix.push_back(grid.worldFromIndex[column][row]);
    return {{"name", grid.name},
            {"class", int(grid.gridClass)},
            {"type", grid.typeName},
            {"scalar", grid.isScalar()},
            {"size", {size.x, size.y, size.z}},
            {"index_min", {grid.indexMin.x, grid.indexMin.y, grid.indexMin.z}},
            {"background", {grid.background.x, grid.background.y, grid.background.z}},
            {"matrix", matrix},
            {"metadata", jsonOf(grid.metadata)}};
}

glm::ivec3 triple(const json& array) { return {array.at(0).get<int>(), array.at(1).get<int>(), array.at(2).get<int>()}; }

template <class Value>
bool receiveValues(const ReadBytes& read, const glm::ivec3& size, VdbGrid& grid) {
    DenseGrid<Value> dense(size, Value(0.0f));
    if (!read(dense.values.data(), dense.values.size() * sizeof(Value)))
        return false;
    grid.values = std::move(dense);
    return true;
}

bool receiveGrid(const ReadBytes& read, const json& header, VdbGrid& grid) {
    grid.name = header.at("name").get<std::string>();
    grid.gridClass = VdbClass(header.at("class").get<int>());
    grid.typeName = header.at("type").get<std::string>();
    grid.indexMin = triple(header.at("index_min"));
    for (int i = 0; i < 3; ++i)
        grid.background[i] = header.at("background").at(std::size_t(i)).get<float>();
    for (int i = 0; i < 16; ++i)
        grid.worldFromIndex[i / 4][i % 4] = header.at("matrix").at(std::size_t(i)).get<double>();
    grid.metadata = metadataFrom(header.at("metadata"));
    const glm::ivec3 size = triple(header.at("size"));
    if (size.x < 0 || size.y < 0 || size.z < 0 || std::int64_t(size.x) * size.y > kMaxVoxels ||
        std::int64_t(size.x) * size.y * size.z > kMaxVoxels)
        return false;
    return header.at("scalar").get<bool>() ? receiveValues<float>(read, size, grid)
                                           : receiveValues<glm::vec3>(read, size, grid);
}

} // namespace

void sendJson(std::FILE* stream, const json& header) {
    const std::string text = header.dump(-1, ' ', false, json::error_handler_t::replace);
    const std::uint64_t length = text.size();
    put(stream, &length, sizeof length);
    put(stream, text.data(), text.size());
}

void sendVdb(std::FILE* stream, const VdbFile& file) {
    json header = {{"metadata", jsonOf(file.metadata)}, {"skipped", file.skippedGrids}, {"grids", json::array()}};
    for (const VdbGrid& grid : file.grids)
        header["grids"].push_back(headerOf(grid));
    sendJson(stream, header);
    for (const VdbGrid& grid : file.grids)
        std::visit([&](const auto& dense) { put(stream, dense.values.data(), dense.values.size() * sizeof dense.values[0]); },
                   grid.values);
}

bool receiveJson(const ReadBytes& read, json& header) {
    std::uint64_t length = 0;
    if (!read(&length, sizeof length) || length > kMaxHeaderBytes)
        return false;
    std::string text(length, '\0');
    if (!read(text.data(), text.size()))
        return false;
    header = json::parse(text, nullptr, false);
    return !header.is_discarded();
}

bool receiveVdb(const ReadBytes& read, VdbFile& file) {
    json header;
    if (!receiveJson(read, header))
        return false;
    try {
        file.metadata = metadataFrom(header.at("metadata"));
        file.skippedGrids = header.at("skipped").get<std::vector<std::string>>();
        for (const json& gridHeader : header.at("grids"))
            if (!receiveGrid(read, gridHeader, file.grids.emplace_back()))
                return false;
    } catch (const json::exception&) {
        return false;
    }
    return true;
}

} // namespace eikonal
