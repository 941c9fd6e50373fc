#pragma once
// Lights in fields with a closed form, and the irradiance that they should leave.

#include <functional>
#include <string>
#include <vector>

#include "common/fields.h"

namespace eikonal::bench {

struct IrradianceCase {
    std::string name;
    Light light;
    Fields fields;
    DenseGrid<double> truth;  ///< means over voxels' cubes, first band; 0 where nothing is compared
};

/// Point light in vacuum, Luneburg's lens, point light in a fish-eye and before plane glass: exact. A smoothed glass sphere:
/// very many rays in double precision through the closed form of its index. At a resolution in voxels along the box's edge.
std::vector<IrradianceCase> irradianceCases(int resolution);

} // namespace eikonal::bench
