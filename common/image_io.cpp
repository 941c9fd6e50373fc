#include "common/image_io.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <system_error>

#include <dlfcn.h>
#include <fmt/format.h>

#include "common/companion.h"
#include "common/error.h"
#include "common/file_kind.h"
#include "common/output_file.h"

namespace fs = std::filesystem;

namespace eikonal {
namespace {

/// Opened once and kept: closing libraries that started threads is not safe.
const ImageCodec& codec() {
    static const ImageCodec opened = [] {
        const fs::path file = findCompanion("eikonal_image.so", EIKONAL_COMPANION_FOLDER);
        void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
        const auto function =
            library ? reinterpret_cast<ImageCodecFunction>(dlsym(library, kImageCodecSymbol)) : nullptr;
        if (!function)
            throw failure(fmt::format("cannot open {}: {}", file.string(), dlerror()));
        return function();
    }();
    return opened;
}

RawImage decode(const fs::path& path, bool linear) {
    std::error_code ignored;
    if (!fs::exists(path, ignored))
        throw badInput(fmt::format("{}: no such file", path.string()));
    RawImage image;
    std::string error;
    if (!codec().decode(path.string(), linear, image, error))
        throw badInput(fmt::format("{}: expected an image, found a file that cannot be read as one ({})", path.string(),
                                   error));
    return image;
}

std::size_t channelIndex(const RawImage& image, const std::string& name, std::size_t fallback) {
    const auto found = std::find(image.names.begin(), image.names.end(), name);
    return found == image.names.end() ? fallback : std::size_t(found - image.names.begin());
}

void requireRadiance(const fs::path& path, const Image& image) {
    for (int y = 0; y < image.size.y; ++y)
        for (int x = 0; x < image.size.x; ++x)
            for (int c = 0; c < 3; ++c) {
                const float value = image.at(x, y)[c];
                if (!std::isfinite(value) || value < 0.0f)
                    throw badInput(fmt::format("{}: expected finite values that are not negative, found {} at pixel "
                                               "x = {}, y = {} ({})",
                                               path.string(), value, x, y, "RGB"[c]));
            }
}

void write(const fs::path& path, const std::string& format, const RawImage& image,
           const ImageAttributes& attributes) {
    requireWritable(path);
    std::vector<unsigned char> bytes;
    std::string error;
    if (!codec().encode(format, image, attributes, bytes, error))
        throw failure(fmt::format("cannot write {}: {}", path.string(), error));
    writeFile(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

} // namespace

Image readImage(const fs::path& path) {
    const RawImage raw = decode(path, true);
    const std::size_t channels = raw.names.size();
    Image image{{raw.width, raw.height}, std::vector<glm::vec3>(std::size_t(raw.width) * std::size_t(raw.height))};
    const std::size_t red = channelIndex(raw, "R", 0);
    const std::size_t green = channelIndex(raw, "G", channels < 3 ? red : 1);
    const std::size_t blue = channelIndex(raw, "B", channels < 3 ? red : 2);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const float* pixel = raw.values.data() + i * channels;
        image.pixels[i] = {pixel[red], pixel[green], pixel[blue]};
    }
    requireRadiance(path, image);
    return image;
}

ChannelImage readChannels(const fs::path& path) {
    const RawImage raw = decode(path, false);
    ChannelImage image{{raw.width, raw.height}, {}};
    const std::size_t channels = raw.names.size(), count = std::size_t(raw.width) * std::size_t(raw.height);
    for (std::size_t c = 0; c < channels; ++c) {
        std::vector<float>& values = image.channels[raw.names[c]];
        values.resize(count);
        for (std::size_t i = 0; i < count; ++i)
            values[i] = raw.values[i * channels + c];
    }
    return image;
}

void writeExr(const fs::path& path, const glm::ivec2& size, const std::vector<ImageChannel>& channels,
              const ImageAttributes& attributes) {
    RawImage raw{size.x, size.y, {}, std::vector<float>(std::size_t(size.x) * std::size_t(size.y) * channels.size())};
    for (std::size_t c = 0; c < channels.size(); ++c) {
        raw.names.push_back(channels[c].name);
        for (std::size_t i = 0; i < channels[c].values->size(); ++i)
            raw.values[i * channels.size() + c] = (*channels[c].values)[i];
    }
    write(path, "exr", raw, attributes);
}

void writeDisplay(const fs::path& path, const glm::ivec2& size, const std::vector<glm::vec3>& pixels) {
    const std::string extension = extensionOf(path);
    if (extension != ".png" && extension != ".jpg" && extension != ".jpeg")
        throw Error(ExitCode::kUsage, fmt::format("{}: expected .exr, .png or .jpg, found '{}'", path.string(), extension));
    RawImage raw{size.x, size.y, {"R", "G", "B"}, {}};
    raw.values.reserve(pixels.size() * 3);
    for (const glm::vec3& pixel : pixels)
        raw.values.insert(raw.values.end(), {pixel.x, pixel.y, pixel.z});
    write(path, extension == ".png" ? "png" : "jpg", raw, {});
}

} // namespace eikonal
