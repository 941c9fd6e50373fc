#include "viewer/tone_map.h"

namespace eikonal::viewer {

std::vector<std::string> toneDefines(ToneMap curve) {
    switch (curve) {
        case ToneMap::kAgx: return {"TONE_AGX"};
        case ToneMap::kReinhard: return {"TONE_REINHARD"};
        case ToneMap::kNone: break;
    }
    return {};
}

ToneMapper::ToneMapper(const gpu::Context& context, ToneMap curve)
    : kernel_(context, "viewer/tone_map.comp.glsl", toneDefines(curve)), display_(context, 0, "display") {}

void ToneMapper::reserve(const gpu::Context& context, std::size_t pixels) {
    const std::size_t bytes = pixels * sizeof(glm::vec4);
    if (display_.bytes() < bytes) display_ = gpu::Buffer(context, bytes, "display");
}

void ToneMapper::run(const RayBatch& batch) const {
    display_.bindStorage(gpu::kStorageDisplay);
    kernel_.dispatch(batch.groups());
}

} // namespace eikonal::viewer
