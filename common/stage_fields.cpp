#include "common/stage_fields.h"

#include <algorithm>

#include "common/insets.h"

namespace eikonal {
namespace {

FieldsOfStage ofStage(const Scene& scene, Fields fields) {
    auto shared = std::make_shared<const Fields>(std::move(fields));
    EffectSet effects = decideEffects(scene, *shared);
    return {std::move(shared), std::move(effects)};
}

bool hasInsets(const Scene& scene) {
    return std::any_of(scene.objects.begin(), scene.objects.end(), [](const Object& object) { return object.resolution; });
}

} // namespace

StageFields composeStageFields(const Scene& scene) {
    const FieldsOfStage light = ofStage(scene, composeFields(scene));
    return {light, hasInsets(scene) ? ofStage(scene, composeImageFields(scene)) : light};
}

StageFields movedStageFields(const Scene& scene, const StageFields& before) {
    requireInsetsComeLast(scene);
    Fields fields = *before.image.fields;
    fields.insets = movedInsets(scene, std::move(fields.insets));
    return {ofStage(scene, composeFields(scene)), ofStage(scene, std::move(fields))};
}

} // namespace eikonal
