#pragma once
// What a slice through the domain shows under the pointer, as numbers.

#include <optional>
#include <string_view>
#include <vector>

#include "common/baked_light.h"
#include "common/fields.h"
#include "viewer/picture.h"

namespace eikonal::window {

bool isSlice(viewer::Look look);

struct SliceProbe {
    std::string_view label;     ///< "index", "irradiance" or "direction"
    std::vector<float> values;  ///< of the voxel that the slice cuts there; empty beside the domain, or where there is no light
};

/// `at`: (0, 0) to (1, 1) over the picture. `fields`: as light sees them. `light` is null where none has been baked. None where no
/// slice is looked at.
std::optional<SliceProbe> probeSlice(const viewer::LookSettings& look, const Camera& camera, const glm::dvec2& at,
                                     double aspect, const Fields& fields, const BakedLight* light);

} // namespace eikonal::window
