#include "common/scene_hash.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "common/scene_toml.h"

namespace eikonal {
namespace {

/// FNV-1a, 64 bits (G. Fowler, L. C. Noll, K.-P. Vo), over bytes for text and over 32-bit words for grids.
class Fnv {
public:
    void add(const std::string& text) {
        for (const char c : text)
            mix(static_cast<unsigned char>(c));
        mix(0);
    }
    template <class Value>
    void add(const DenseGrid<Value>& grid) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(grid.values.data());
        const std::size_t count = grid.values.size() * sizeof(Value);
        mix(count);
        for (std::size_t i = 0; i < count; i += 4) {
            std::uint32_t word = 0;
            std::copy_n(bytes + i, std::min<std::size_t>(4, count - i), reinterpret_cast<unsigned char*>(&word));
            mix(word);
        }
    }
    std::string digits() const { return fmt::format("{:016x}", state_); }

private:
    void mix(std::uint64_t value) { state_ = (state_ ^ value) * 0x100000001b3ull; }
    std::uint64_t state_ = 0xcbf29ce484222325ull;
};

/// Empty for a file that cannot be read, of which others tell.
std::string contentsOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

bool matters(const Scene& scene, const std::string& section, const std::string& key) {
    if (section == "camera")
        return false;
    if (section == "render")
        return key == "effects";
    if (section == "environment")
        return scene.environment.bake;
    if (section == "accuracy")
        return key != "integrator";  // of viewing rays
    const bool isOfObject = section.rfind("object.", 0) == 0;
    const bool onlyInImages = key == "surface" || key == "roughness" || (isOfObject && key == "resolution") ||
                              (key == "reflection_tint" && scene.accuracy.reflections == 0);
    return key != "name" && !onlyInImages;
}

} // namespace

std::vector<std::pair<std::string, std::string>> bakeKeys(const Scene& scene) {
    std::vector<std::pair<std::string, std::string>> keys;
    for (const WrittenSection& section : writeSections(scene))
        for (const auto& [key, text] : section.values)
            if (matters(scene, section.path, key))
                keys.emplace_back(section.path + "." + key, text);
    return keys;
}

std::string sceneHash(const Scene& scene, const Fields& fields) {
    Fnv hash;
    for (const auto& [key, text] : bakeKeys(scene)) {
        hash.add(key);
        hash.add(text);
    }
    hash.add(fmt::format("{}", fields.iorUniform));
    hash.add(fields.ior);
    hash.add(fields.cauchyB);
    hash.add(fields.interface);
    hash.add(fields.sigmaA);
    hash.add(fields.sigmaS);
    hash.add(fields.anisotropy);
    if (!fields.anisotropyByBand.empty())
        hash.add(fields.anisotropyByBand);
    hash.add(fields.emission);
    hash.add(fields.opaque);
    hash.add(fields.albedo);
    if (scene.environment.bake && scene.environment.image)
        hash.add(contentsOf(scene.resolve(*scene.environment.image)));
    return hash.digits();
}

std::vector<std::string> differingKeys(const Scene& a, const Scene& b) {
    const auto keysOfA = bakeKeys(a), keysOfB = bakeKeys(b);
    const std::map<std::string, std::string> textsOfA(keysOfA.begin(), keysOfA.end());
    const std::map<std::string, std::string> textsOfB(keysOfB.begin(), keysOfB.end());
    std::vector<std::string> names;
    for (const auto& [key, text] : keysOfA)
        if (const auto other = textsOfB.find(key); other == textsOfB.end() || other->second != text)
            names.push_back(key);
    for (const auto& [key, text] : keysOfB)
        if (!textsOfA.contains(key))
            names.push_back(key);
    return names;
}

} // namespace eikonal
