#pragma once
// The fields of a scene as each stage needs them.

#include <memory>

#include "common/effects.h"
#include "common/fields.h"

namespace eikonal {

struct FieldsOfStage {
    std::shared_ptr<const Fields> fields;
    EffectSet effects;
};

/// Light bends through all objects as they are on the domain's lattice, and is seen through each on the finest that it has.
struct StageFields {
    FieldsOfStage light;  ///< composeFields
    FieldsOfStage image;  ///< composeImageFields; the same where no object has a resolution of its own
};

/// Throws badInput as composeImageFields.
StageFields composeStageFields(const Scene& scene);

/// The same where `scene` differs from that of `before` in nothing but where objects with a resolution are: no grid of the image
/// is composed anew.
StageFields movedStageFields(const Scene& scene, const StageFields& before);

} // namespace eikonal
