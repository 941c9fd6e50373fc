#include "viewer/image_file.h"

#include "common/file_kind.h"
#include "common/scene_toml.h"
#include "viewer/view.h"

namespace eikonal {

namespace {

struct CameraMatrices {
    glm::mat4 cameraFromWorld, ndcFromWorld;  ///< the latter before its division by w
};

CameraMatrices matricesOf(const Camera& camera, const glm::ivec2& imageSize) {
    gpu::ViewBlock view{};
    viewer::configureCamera(view, camera, imageSize);
    const glm::vec3 right = glm::normalize(view.cameraRight), up = glm::normalize(view.cameraUp);
    const glm::mat3 axes = glm::transpose(glm::mat3(right, up, view.cameraForward));
    CameraMatrices matrices{glm::mat4(axes), glm::mat4(0.0f)};
    matrices.cameraFromWorld[3] = glm::vec4(-(axes * view.cameraPosition), 1.0f);
    glm::mat4 ndcFromCamera(0.0f);  // by columns: what x, y, z and 1 add to x, y, z, w
    ndcFromCamera[0] = {0.5f / glm::length(view.cameraRight), 0.0f, 0.0f, 0.0f};
    ndcFromCamera[1] = {0.0f, -0.5f / glm::length(view.cameraUp), 0.0f, 0.0f};
    ndcFromCamera[2] = {0.5f, 0.5f, 0.0f, 1.0f};
    ndcFromCamera[3] = {0.0f, 0.0f, 1.0f, 0.0f};  // z is one over the distance: nothing is lost
    matrices.ndcFromWorld = ndcFromCamera * matrices.cameraFromWorld;
    return matrices;
}

} // namespace

ImageAttributes attributesOf(const RenderResult& image, const Scene& scene, const std::string& creator) {
    const CameraMatrices matrices = matricesOf(scene.camera, image.size);
    ImageAttributes attributes{{"creator", creator},
                               {"software", creator},
                               {"scene", resolvedToml(scene)},
                               {"worldToCamera", matrices.cameraFromWorld},
                               {"worldToNDC", matrices.ndcFromWorld}};
    const RenderStatistics& statistics = image.statistics;
    if (!statistics.seconds.empty()) attributes.push_back({"seconds", float(statistics.seconds.back().second)});
    if (statistics.samples > 0.0) attributes.push_back({"samples", float(statistics.samples)});
    if (statistics.samples >= 2.0) attributes.push_back({"noise", float(statistics.noise)});
    return attributes;
}

bool hasChannels(const std::filesystem::path& file) {
    return extensionOf(file) == ".exr";
}

void writeRendered(const std::filesystem::path& file, const RenderResult& image, const ImageAttributes& attributes) {
    if (!hasChannels(file)) {
        writeDisplay(file, image.size, image.display);
        return;
    }
    std::vector<ImageChannel> channels;
    for (const RenderChannel& channel : image.channels) channels.push_back({channel.name, &channel.values});
    writeExr(file, image.size, channels, attributes);
}

} // namespace eikonal
