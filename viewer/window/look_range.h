#pragma once
// What a way to look begins with: a range that its values fill, and the middle of the domain.

#include "common/baked_light.h"
#include "common/fields.h"
#include "viewer/picture.h"

namespace eikonal::window {

/// `look` with the range of what it shows. `light` is null where none has been baked.
viewer::LookSettings withRange(viewer::LookSettings look, const Fields& fields, const BakedLight* light);

/// The middle of the domain along an axis.
double middleOf(const Lattice& domain, int axis);

} // namespace eikonal::window
