#pragma once
// A glass sphere in smoke, a beam and a sky, and its image by the double-precision reference.

#include "common/baked_light.h"
#include "common/fields.h"

namespace eikonal::bench {

struct ImageCase {
    Scene scene;
    Fields fields;
    BakedLight light;  ///< by very many rays in double precision through the same voxels
};

using Radiances = std::vector<glm::dvec3>;  ///< of pixels, row after row from the top

/// `pixels` and `resolution`: along an edge of the image, and of the box.
ImageCase imageCase(int pixels, int resolution);

/// Mean of samplesPerEdge² rays a pixel in equal strata, at a step far below where images change.
Radiances referenceImage(const ImageCase& seen, int samplesPerEdge);

} // namespace eikonal::bench
