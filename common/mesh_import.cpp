// Meshes from files, through assimp.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <unordered_map>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include "common/error.h"
#include "common/mesh.h"

namespace fs = std::filesystem;

// The library calls this where its own checks fail, and aborts unless the program brings another.
namespace Assimp {
void aiAssertViolation(const char* failedExpression, const char* file, int line) {
    throw std::runtime_error(fmt::format("{}:{}: {}", file, line, failedExpression));
}
} // namespace Assimp

namespace eikonal {
namespace {

struct VertexHash {
    std::size_t operator()(const glm::dvec3& v) const {
        std::size_t hash = 0;
        for (int i = 0; i < 3; ++i)
            hash = hash * 1099511628211u ^ std::hash<double>()(v[i]);
        return hash;
    }
};

/// Collects triangles; vertices at equal positions become one.
class Welder {
public:
    explicit Welder(Mesh& mesh) : mesh_(mesh) {}

    int vertex(const glm::dvec3& position) {
        const auto [entry, isNew] = indices_.try_emplace(position + 0.0, int(mesh_.vertices.size()));  // -0 equals 0
        if (isNew)
            mesh_.vertices.push_back(position);
        return entry->second;
    }

    void triangle(const glm::ivec3& t) {
        if (t.x != t.y && t.y != t.z && t.z != t.x)
            mesh_.triangles.push_back(t);
    }

private:
    Mesh& mesh_;
    std::unordered_map<glm::dvec3, int, VertexHash> indices_;
};

void addMesh(const fs::path& path, const aiMesh& source, Welder& welder) {
    std::vector<int> indices(source.mNumVertices);
    for (unsigned v = 0; v < source.mNumVertices; ++v) {
        const aiVector3D& p = source.mVertices[v];
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            throw badInput(fmt::format("{}: expected finite coordinates, found ({}, {}, {}) at vertex {}", path.string(), p.x,
                                       p.y, p.z, v));
        indices[v] = welder.vertex({p.x, p.y, p.z});
    }
    for (unsigned f = 0; f < source.mNumFaces; ++f) {
        const aiFace& face = source.mFaces[f];
        if (face.mNumIndices == 3 && std::max({face.mIndices[0], face.mIndices[1], face.mIndices[2]}) < indices.size())
            welder.triangle({indices[face.mIndices[0]], indices[face.mIndices[1]], indices[face.mIndices[2]]});
    }
}

/// Whether one of the lines is this word and nothing else but blanks.
bool hasLine(std::string_view text, std::string_view word) {
    constexpr std::string_view kBlanks = " \t\r";
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        const std::size_t first = std::min(line.find_first_not_of(kBlanks), line.size());
        if (line.substr(first, line.find_last_not_of(kBlanks) + 1 - first) == word) return true;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return false;
}

/// The library looks for the end of a PLY header for ever.
void requireEndOfHeader(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    constexpr std::size_t kLongestHeader = 1u << 20;
    std::string start(kLongestHeader, '\0');
    file.read(start.data(), std::streamsize(start.size()));
    start.resize(std::size_t(file.gcount()));
    if (start.starts_with("ply") && !hasLine(start, "end_header"))
        throw badInput(fmt::format("{}: expected a PLY header that ends in 'end_header', found no such line: damaged file",
                                   path.string()));
}

/// The library's own steps look vertices up without asking whether they are there.
void requireKnownVertices(const fs::path& path, const aiScene& scene) {
    for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
        for (const aiFace& face : std::span(mesh->mFaces, mesh->mNumFaces)) {
            for (const unsigned index : std::span(face.mIndices, face.mNumIndices)) {
                if (index >= mesh->mNumVertices)
                    throw badInput(fmt::format("{}: expected faces of the {} vertices that there are, found one of number {}: "
                                               "damaged file", path.string(), mesh->mNumVertices, index));
            }
        }
    }
}

/// nullptr: it is no mesh, or none that the library can prepare.
const aiScene* readScene(Assimp::Importer& importer, const fs::path& path) {
    // What differs between copies of a position would keep them from being welded.
    importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS |
                                                            aiComponent_COLORS | aiComponent_TEXCOORDS |
                                                            aiComponent_BONEWEIGHTS | aiComponent_MATERIALS |
                                                            aiComponent_TEXTURES | aiComponent_LIGHTS |
                                                            aiComponent_CAMERAS);
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    try {
        const aiScene* scene = importer.ReadFile(path.string(), 0);
        if (!scene) return nullptr;
        requireKnownVertices(path, *scene);
        return importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_RemoveComponent | aiProcess_SortByPType |
                                            aiProcess_PreTransformVertices);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& e) {
        throw badInput(fmt::format("{}: damaged mesh file ({})", path.string(), e.what()));
    }
}

} // namespace

Mesh loadMesh(const fs::path& path) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored))
        throw badInput(fmt::format("{}: expected a mesh file (OBJ, PLY, STL, glTF), found no such file", path.string()));
    requireEndOfHeader(path);
    Assimp::Importer importer;
    const aiScene* scene = readScene(importer, path);
    if (!scene)
        throw badInput(fmt::format("{}: expected a mesh (OBJ, PLY, STL, glTF), found a file that cannot be read as one ({})",
                                   path.string(), importer.GetErrorString()));
    Mesh mesh;
    Welder welder(mesh);
    for (unsigned m = 0; m < scene->mNumMeshes; ++m)
        addMesh(path, *scene->mMeshes[m], welder);
    if (mesh.triangles.empty())
        throw badInput(fmt::format("{}: expected a mesh with triangles, found none", path.string()));
    return mesh;
}

} // namespace eikonal
