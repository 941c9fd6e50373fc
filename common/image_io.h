#pragma once
// Images in and out. The library behind is opened on first use: it costs 0.3 s and 132 MB, which most commands spare.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "common/image_codec.h"

namespace eikonal {

/// Linear Rec.709, row after row from the top.
struct Image {
    glm::ivec2 size{0};
    std::vector<glm::vec3> pixels;

    const glm::vec3& at(int x, int y) const { return pixels[std::size_t(y) * std::size_t(size.x) + std::size_t(x)]; }
};

/// Reads OpenEXR, Radiance HDR, PNG, JPEG, ... as linear RGB (8-bit formats through their colour space's curve).
/// Throws badInput for a file that is missing or no image, and for a pixel that is not finite or negative, naming it.
Image readImage(const std::filesystem::path& path);

/// One channel of an image: its conventional name ("R", "Z", "depth.R", ...) and size.x · size.y values.
struct ImageChannel {
    std::string name;
    const std::vector<float>* values = nullptr;
};

/// Channels of an EXR by name, all as float.
struct ChannelImage {
    glm::ivec2 size{0};
    std::map<std::string, std::vector<float>> channels;
};
ChannelImage readChannels(const std::filesystem::path& path);

/// Writes linear float OpenEXR; equal inputs give equal bytes. Throws failure for an unwritable folder or a full disk.
void writeExr(const std::filesystem::path& path, const glm::ivec2& size, const std::vector<ImageChannel>& channels,
              const ImageAttributes& attributes);

/// Writes .png or .jpg from display-encoded values in 0 to 1 (clamped, rounded to 8 bits).
/// Throws Error with kUsage for another extension, failure for an unwritable folder or a full disk.
void writeDisplay(const std::filesystem::path& path, const glm::ivec2& size, const std::vector<glm::vec3>& pixels);

} // namespace eikonal
