#pragma once
// Scenes by chance, each from its seed: smooth fields of the index, objects, matter, lights and cameras of all kinds.

#include <cstdint>
#include <string>

namespace eikonal::test {

/// The text of a scene of 8 to 14 voxels along the edge.
std::string randomScene(std::uint64_t seed);

/// A smooth index between 1 and about 2 as an expression: a sum of Gaussians.
std::string randomIndex(std::uint64_t seed);

} // namespace eikonal::test
