#pragma once
// Properties that hold of every scene, checked on those of random_scene.

#include <cstdint>

namespace eikonal::test {

/// Bake and picture are sound (hard_cases.h; the share of the grid aside), and repeat to the bit.
void expectSceneProperties(std::uint64_t seed);

/// Rays through a smooth random field come back to where they started, after the same optical path.
void expectRayProperties(std::uint64_t seed);

} // namespace eikonal::test
