#pragma once
// A rendered image as a file.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "viewer/render.h"

namespace eikonal {

/// .exr: linear, with all channels and these attributes; .png and .jpg: tone-mapped. Throws as writeExr and writeDisplay.
void writeRendered(const std::filesystem::path& file, const RenderResult& image,
                   const std::vector<std::pair<std::string, std::string>>& attributes);

} // namespace eikonal
