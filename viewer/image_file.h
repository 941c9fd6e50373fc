#pragma once
// A rendered image as a file.

#include <filesystem>
#include <string>

#include "common/image_io.h"
#include "viewer/render.h"

namespace eikonal {

/// What an OpenEXR of a scene's image says beside its pixels: `creator` and `software`; `scene`, TOML with everything resolved;
/// `worldToCamera` and `worldToNDC`, as OpenEXR defines them (camera space is left-handed, y up, z along the view; x and y of
/// NDC go from 0 at the upper left to 1); `seconds`, `samples` and `noise`, where the image has statistics.
ImageAttributes attributesOf(const RenderResult& image, const Scene& scene, const std::string& creator);

/// Whether an image by that name has more than what is displayed.
bool hasChannels(const std::filesystem::path& file);

/// .exr: linear, with all channels and these attributes; .png and .jpg: tone-mapped. Throws as writeExr and writeDisplay.
void writeRendered(const std::filesystem::path& file, const RenderResult& image, const ImageAttributes& attributes);

} // namespace eikonal
