#pragma once
// Texture units and block bindings that every kernel keeps to.

#ifdef __cplusplus
namespace eikonal::gpu {
#endif

const int kUnitOptics = 0;          // grad n in rgb [1 / scene unit], n in alpha; or rows of spline coefficients
const int kUnitInterface = 1;       // 1 inside the band of a boundary that changes n
const int kUnitSigmaA = 2;          // absorption in rgb [1 / scene unit]
const int kUnitSigmaS = 3;          // scattering in rgb [1 / scene unit], Henyey-Greenstein g in alpha
const int kUnitEmission = 4;        // radiance per scene unit in rgb
const int kUnitOpaque = 5;          // albedo in rgb, coverage in alpha
const int kUnitIrradiance = 6;      // scalar irradiance in rgb (viewer)
const int kUnitLightDirection = 7;  // flux vector over scalar irradiance in rgb, 1 + row of lobes or 0 in alpha (viewer)
const int kUnitEnvironment = 8;     // latitude-longitude radiance in rgb (viewer)
const int kUnitLobes = 9;           // lobes of voxels that have several, a row of texels each (viewer)
const int kUnitClearance = 10;      // bricks to the next that rays cannot fly through, or can, about kNoClearance (viewer)
const int kUnitDispersion = 11;     // grad B in rgb [micrometres^2 / scene unit], Cauchy's B in alpha [micrometres^2]
const int kUnitSurface = 12;        // of boundaries: factor on what they reflect in rgb, roughness in alpha (viewer)
const int kUnitDetail = 13;         // bricks to the next that rays voxels apart may pass unseen (light simulator)
const int kUnitInsetValues = 14;    // atlas of objects with lattices of their own (shared/inset_blocks.h)
const int kUnitInsetExtents = 15;   // the same: area coverage in red, 1 in green inside the band of the boundary
const int kUnitRays = 16;           // rows of rays under way (viewer)
const int kUnitFilm = 17;           // rows of the film's pixels (viewer)
const int kUnitComparedFilm = 18;   // the same of another film (viewer)
const int kUnitTubePositions = 19;  // samples of tracks (light simulator)
const int kUnitTubeShares = 20;     // the same
const int kUnitTubeCells = 21;      // rows of cells (light simulator)
const int kUnitInsetRows = 22;      // rows of objects with lattices of their own
const int kUnitInsetBricks = 23;    // of which bricks of the domain they are about, two bricks a row
const int kUnitAnisotropy = 24;     // Henyey-Greenstein g of each band in rgb

// Table of lobes: a row is a voxel's three, the strongest first, each irradiance and flux vector over it; so many rows lie
// side by side.
const int kLobesPerRow = 3;
const int kTexelsPerLobe = 2;
const int kLobeRowsAcross = 512;

const int kUniformDomain = 0;  // DomainBlock; stages use 1 and beyond

#ifdef __cplusplus
} // namespace eikonal::gpu
#endif
