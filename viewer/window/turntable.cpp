#include "viewer/window/turntable.h"

#include <optional>

#include "common/gpu/context.h"
#include "lightsim/bake.h"
#include "viewer/image_file.h"
#include "viewer/window/document.h"
#include "viewer/window/orbit.h"

namespace eikonal::window {

namespace {

constexpr double kTurn = 2.0 * 3.14159265358979323846;

std::optional<BakedLight> lightOf(const gpu::Context& context, const Document& document, const TurntableOptions& options) {
    if (!document.wantsLight()) return std::nullopt;
    BakeOptions bakeOptions;
    bakeOptions.progress = [&](double fraction) { options.progress("simulating light", fraction); };
    return bakeScene(context, document.scene(), *document.light().fields, document.light().effects, bakeOptions).light;
}

} // namespace

void writeTurntable(const TurntableOptions& options) {
    const Document document(options.file, options.overrides);
    const gpu::Context context = gpu::Context::windowless();
    const std::optional<BakedLight> light = lightOf(context, document, options);
    Scene scene = document.scene();
    const Camera start = scene.camera;
    ProgressiveImage image(context, scene, *document.image().fields, document.image().effects, light ? &*light : nullptr, {});
    for (int frame = 0; frame < options.frames; ++frame) {
        scene.camera = orbited(start, {kTurn * frame / options.frames, 0.0});
        image.setCamera(scene.camera);
        const auto progress = [&](double fraction) { options.progress("rendering", (frame + fraction) / options.frames); };
        const std::string name = options.nameOf(frame);
        const RenderResult result = renderFrame(image, scene.render, progress, hasChannels(name));
        context.throwIfError();
        writeRendered(name, result, attributesOf(result, scene, options.creator));
    }
}

} // namespace eikonal::window
