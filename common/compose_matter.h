#pragma once
// Steps of composeFields: one object onto what lies there already.

#include "common/compose_layer.h"
#include "common/fields.h"

namespace eikonal {

/// All of the below, in turn.
void composeLayer(const ObjectLayer& layer, Fields& fields);

/// n <- n + coverage (n_object - n); boundaries that this changes are marked, those that it buries are cleared.
void composeIndex(const ObjectLayer& layer, Fields& fields);

/// Tint and roughness of the object's boundary, in its band.
void composeSurface(const ObjectLayer& layer, Fields& fields);

/// Cauchy's B, composed like the index that it belongs to.
void composeDispersion(const ObjectLayer& layer, Fields& fields);

/// An index that is given over a box, as a grid or a field, holds vacuum too, and says by itself where: B goes with it.
bool tellsMatterByIndex(const ObjectLayer& layer);

/// Absorption, scattering with its anisotropy, and emission, by area coverage.
void composeMedia(const ObjectLayer& layer, Fields& fields);

/// Opaque matter and its albedo; transparent matter takes opaque matter away.
void composeOpaque(const ObjectLayer& layer, Fields& fields);

/// Grids that hold nothing become empty; anisotropy and albedo continue by a voxel beyond the matter that they belong to,
/// because interpolation reaches that far; a uniform index becomes one number.
void finishFields(Fields& fields);

} // namespace eikonal
