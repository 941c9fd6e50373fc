#pragma once
// Where a deposit adds light.

#include <string>
#include <vector>

namespace eikonal::bake {

class VoxelSums {
public:
    virtual ~VoxelSums() = default;

    /// To the bindings of shaders/lightsim/sums.glsl.
    virtual void bind() const = 0;
    /// Whether deposits are to be compiled with LIGHT_LOBES.
    virtual bool areLobes() const = 0;
};

/// #defines of deposits into bins of direction.
inline std::vector<std::string> withLobes(std::vector<std::string> defines) {
    defines.emplace_back("LIGHT_LOBES");
    return defines;
}

} // namespace eikonal::bake
