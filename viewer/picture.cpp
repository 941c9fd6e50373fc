#include "viewer/picture.h"

#include "viewer/tone_map.h"

namespace eikonal::viewer {

namespace {

std::vector<std::string> lookDefines(Look look) {
    switch (look) {
        case Look::kImage: return {};
        case Look::kRadiance: return {"LOOK_RADIANCE"};
        case Look::kSteps: return {"LOOK_STEPS"};
        case Look::kIrradiance: return {"LOOK_SLICE"};
        case Look::kDirection: return {"LOOK_SLICE", "LOOK_DIRECTION"};
        case Look::kError: return {"LOOK_ERROR"};
        case Look::kIndex: break;
    }
    return {"LOOK_SLICE", "LOOK_INDEX"};
}

} // namespace

PicturePainter::PicturePainter(const gpu::Context& context, std::vector<std::string> defines, ToneMap curve)
    : context_(context), defines_(std::move(defines)), block_(context, sizeof(gpu::LookBlock), "look") {
    for (const std::string& define : toneDefines(curve)) defines_.push_back(define);
}

void PicturePainter::run(const RayBatch& batch, const LookSettings& look, const gpu::Texture2D& picture) {
    auto kernel = kernels_.find(look.look);
    if (kernel == kernels_.end()) {
        std::vector<std::string> defines = defines_;
        for (const std::string& define : lookDefines(look.look)) defines.push_back(define);
        kernel = kernels_.emplace(look.look, gpu::Kernel(context_, "viewer/picture.comp.glsl", defines)).first;
    }
    block_.upload(gpu::LookBlock{look.sliceAxis, float(look.slicePosition), float(look.lowest), float(look.highest)});
    block_.bindUniform(gpu::kUniformLook);
    picture.bindImage(gpu::kImagePicture);
    kernel->second.dispatch(batch.groups());
}

} // namespace eikonal::viewer
