#include "viewer/image_file.h"

#include <algorithm>
#include <cctype>

#include "common/image_io.h"

namespace eikonal {

void writeRendered(const std::filesystem::path& file, const RenderResult& image,
                   const std::vector<std::pair<std::string, std::string>>& attributes) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
    if (extension != ".exr") {
        writeDisplay(file, image.size, image.display);
        return;
    }
    std::vector<ImageChannel> channels;
    for (const RenderChannel& channel : image.channels) channels.push_back({channel.name, &channel.values});
    writeExr(file, image.size, channels, attributes);
}

} // namespace eikonal
