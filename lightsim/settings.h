#pragma once
// What the accuracy of a scene means for the bake.

#include "common/fields.h"
#include "lightsim/bake.h"
#include "lightsim/emit.h"
#include "shaders/shared/tube_blocks.h"

namespace eikonal::bake {

/// Sizes and thresholds that follow from the scene's tolerance.
struct Criteria {
    double opticalStep;  ///< [scene units]
    double maxSide;      ///< of a patch; of a cell of the launch grids for ray tubes [scene units]
    double coarseness;   ///< of the launch grids about a light nearby: how many times wider than usual their cells are
    double splitShare;   ///< of a light's power: patches with less left are not split
    double cullShare;    ///< of a patch's launched power: patches with less left end
    double maxOpticalPath;  ///< patches that have come further end [scene units]
    bool foldsEnd;       ///< patches that turn inside out are culled
};

/// Patches as in 2007 rather than ray tubes.
bool usesPatches(const Accuracy& accuracy);

/// Of the index where light bends, on the domain's voxels `ior`. `auto` is cubic for ray tubes, which spend little on the index,
/// unless most of its curvature is kinks; patches pay for every step, as viewing rays do (docs/accuracy.md).
Interpolation interpolationOfLight(const Accuracy& accuracy, const DenseGrid<float>& ior);

/// `meshScale` as in BakeOptions.
Criteria criteriaOf(const Accuracy& accuracy, const Fields& fields, double meshScale = 1.0);

/// The uniform block of the kernels, fixed-point scales chosen so that no sum can overflow.
BakeSettings settingsOf(const Criteria& criteria, const LaunchGrids& grids, const Fields& fields,
                        const BakeOptions& options);

/// What the tolerance means for ray tubes.
TubeSettings tubeSettingsOf(const Accuracy& accuracy, const Fields& fields);

/// Whether every optical constant that changes light on its way is grey.
bool isGreyMatter(const Fields& fields, const EffectSet& effects, const Accuracy& accuracy);

/// Whether every light has the same strength in all bands.
bool isGreyLight(const LightSet& lights);

} // namespace eikonal::bake
