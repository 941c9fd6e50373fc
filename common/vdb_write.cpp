// Writing VDB files. Through io::Stream to a stream of ours: io::File::write reports nothing on a full disk.

#include <cerrno>
#include <cmath>
#include <fstream>
#include <system_error>

#include <fmt/format.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>

#include "common/error.h"
#include "common/output_file.h"
#include "common/vdb_io.h"
#include "common/vdb_limits.h"

namespace eikonal {
namespace {

// OpenVDB takes transforms of a smaller determinant for singular, writing and reading.
const double kLeastVoxel = std::cbrt(3.0 * openvdb::math::Tolerance<double>::value());

openvdb::math::Transform::Ptr transformOf(const Lattice& lattice) {
    auto transform = openvdb::math::Transform::createLinearTransform(lattice.voxel);
    const glm::dvec3 origin = lattice.worldFromIndex(glm::ivec3(0));
    transform->postTranslate(openvdb::Vec3d(origin.x, origin.y, origin.z));
    return transform;
}

openvdb::GridClass classOf(VdbClass gridClass) {
    switch (gridClass) {
    case VdbClass::kFogVolume:
        return openvdb::GRID_FOG_VOLUME;
    case VdbClass::kLevelSet:
        return openvdb::GRID_LEVEL_SET;
    case VdbClass::kUnknown:
        break;
    }
    return openvdb::GRID_UNKNOWN;
}

float toVdb(float value) { return value; }
openvdb::Vec3s toVdb(const glm::vec3& value) { return {value.x, value.y, value.z}; }

/// Leaf by leaf; every voxel of the lattice becomes active, and none beyond it.
template <class Grid, class Value>
typename Grid::Ptr gridFrom(const DenseGrid<Value>& dense, const typename Grid::ValueType& background) {
    auto grid = Grid::create(background);
    const openvdb::CoordBBox all(openvdb::Coord(0), openvdb::Coord(dense.size.x - 1, dense.size.y - 1, dense.size.z - 1));
    using Leaf = typename Grid::TreeType::LeafNodeType;
    constexpr int kEdge = int(Leaf::DIM);
    for (int k = 0; k < dense.size.z; k += kEdge)
        for (int j = 0; j < dense.size.y; j += kEdge)
            for (int i = 0; i < dense.size.x; i += kEdge) {
                auto* leaf = new Leaf(openvdb::Coord(i, j, k), background, false);
                openvdb::CoordBBox part = leaf->getNodeBoundingBox();
                part.intersect(all);
                for (auto at = part.begin(); at; ++at)
                    leaf->setValueOn(*at, toVdb(dense.at((*at).x(), (*at).y(), (*at).z())));
                grid->tree().addLeaf(leaf);
            }
    return grid;
}

openvdb::GridBase::Ptr gridFrom(const NamedGrid& named) {
    if (const auto* scalar = std::get_if<const DenseGrid<float>*>(&named.values))
        return gridFrom<openvdb::FloatGrid>(**scalar, named.background.x);
    return gridFrom<openvdb::Vec3SGrid>(*std::get<const DenseGrid<glm::vec3>*>(named.values), toVdb(named.background));
}

openvdb::MetaMap metaMapOf(const Metadata& metadata) {
    openvdb::MetaMap result;
    for (const auto& [key, value] : metadata) {
        if (const auto* number = std::get_if<double>(&value))
            result.insertMeta(key, openvdb::DoubleMetadata(*number));
        else
            result.insertMeta(key, openvdb::StringMetadata(std::get<std::string>(value)));
    }
    return result;
}

void writeChecked(const OutputFile& output, const openvdb::GridCPtrVec& grids, const openvdb::MetaMap& metadata) {
    const auto fail = [&](const std::string& why) {
        return failure(fmt::format("cannot write {}: {}", output.target().string(), why));
    };
    errno = 0;
    try {
        std::ofstream file(output.path(), std::ios::binary | std::ios::trunc);
        openvdb::io::Stream stream(file);
        stream.setCompression(openvdb::io::Archive::DEFAULT_COMPRESSION_FLAGS);
        stream.write(grids, metadata);
        file.close();
        if (!file)
            throw fail(errno != 0 ? std::generic_category().message(errno) : "is the disk full?");
    } catch (const openvdb::Exception& e) {
        throw fail(errno != 0 ? std::generic_category().message(errno) : e.what());
    }
}

} // namespace

void requireVdbHolds(const std::filesystem::path& path, const Lattice& lattice) {
    if (!(lattice.voxel > kLeastVoxel))
        throw badInput(fmt::format("{}: expected voxels of more than {:.2g} scene units, which is the least that a VDB file "
                                   "holds, found {:.2g}: choose a smaller unit of length", path.string(), kLeastVoxel,
                                   lattice.voxel));
}

void writeVdb(const std::filesystem::path& path, const Lattice& lattice, const std::vector<NamedGrid>& grids,
              const Metadata& metadata) {
    openvdb::initialize();
    requireVdbHolds(path, lattice);
    OutputFile output(path);
    openvdb::GridCPtrVec list;
    for (const NamedGrid& named : grids) {
        openvdb::GridBase::Ptr grid = gridFrom(named);
        grid->setName(named.name);
        grid->setGridClass(classOf(named.gridClass));
        grid->setTransform(transformOf(lattice));
        list.push_back(grid);
    }
    writeChecked(output, list, metaMapOf(metadata));
    output.commit();
}

} // namespace eikonal
