#include "viewer/tone_map.h"

namespace eikonal::viewer {

namespace {

std::vector<std::string> curveDefines(ToneMap curve) {
    switch (curve) {
        case ToneMap::kAgx: return {"TONE_AGX"};
        case ToneMap::kReinhard: return {"TONE_REINHARD"};
        case ToneMap::kNone: break;
    }
    return {};
}

} // namespace

ToneMapper::ToneMapper(const gpu::Context& context, ToneMap curve, std::size_t capacity)
    : kernel_(context, "viewer/tone_map.comp.glsl", curveDefines(curve)),
      display_(context, capacity * sizeof(glm::vec4), "display") {}

void ToneMapper::run(const RayBatch& batch) const {
    display_.bindStorage(gpu::kStorageDisplay);
    kernel_.dispatch(batch.groups());
}

} // namespace eikonal::viewer
