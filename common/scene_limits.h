#pragma once
// What numbers of a scene may be at all.

namespace eikonal {

/// Largest magnitude of any number of a scene: single precision holds the product of two.
inline constexpr double kLargestNumber = 1e15;

/// Bounds of the refractive index. Light goes by steps of constant optical path, which the least index of a scene shortens, so
/// that the time of a bake grows with the ratio of the largest index to the least, or to 1.
inline constexpr double kLeastIor = 1e-5, kLargestIor = 1e3;

} // namespace eikonal
