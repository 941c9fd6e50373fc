// The image module: OpenImageIO behind two functions.

#include <algorithm>
#include <cmath>
#include <exception>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include "common/image_codec.h"

namespace eikonal {
namespace {

bool isDisplayReferred(const OIIO::ImageSpec& spec) {
    return spec.format == OIIO::TypeDesc::UINT8 || spec.format == OIIO::TypeDesc::UINT16;
}

bool decodeFile(const std::string& file, bool linear, RawImage& image, std::string& error) {
    OIIO::ImageBuf buffer(file);
    if (!buffer.read(0, 0, true, OIIO::TypeDesc::FLOAT)) {
        error = buffer.geterror();
        return false;
    }
    if (linear && isDisplayReferred(buffer.nativespec())) {
        const OIIO::ImageBuf encoded = buffer;
        if (!OIIO::ImageBufAlgo::colorconvert(buffer, encoded, "sRGB", "linear")) {
            error = buffer.geterror();
            return false;
        }
    }
    const OIIO::ImageSpec& spec = buffer.spec();
    image.width = spec.width;
    image.height = spec.height;
    image.names = spec.channelnames;
    image.values.resize(std::size_t(spec.width) * std::size_t(spec.height) * std::size_t(spec.nchannels));
    if (!buffer.get_pixels(buffer.roi(), OIIO::TypeDesc::FLOAT, image.values.data())) {
        error = buffer.geterror();
        return false;
    }
    return true;
}

void setAttribute(OIIO::ImageSpec& spec, const std::string& key, const std::string& value) { spec.attribute(key, value); }

void setAttribute(OIIO::ImageSpec& spec, const std::string& key, float value) { spec.attribute(key, value); }

/// A matrix by columns for column vectors is the same sixteen numbers as one by rows for row vectors.
void setAttribute(OIIO::ImageSpec& spec, const std::string& key, const glm::mat4& value) {
    spec.attribute(key, OIIO::TypeMatrix, &value[0][0]);
}

OIIO::ImageSpec specOf(const std::string& format, const RawImage& image, const ImageAttributes& attributes) {
    OIIO::ImageSpec spec(image.width, image.height, int(image.names.size()),
                         format == "exr" ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
    spec.channelnames = image.names;
    for (const auto& [key, value] : attributes)
        std::visit([&, &name = key](const auto& held) { setAttribute(spec, name, held); }, value);
    if (format == "exr") {
        spec.attribute("oiio:ColorSpace", "Linear");
        spec.attribute("compression", "zip");
        spec.attribute("DateTime", "1970:01:01 00:00:00");  // the writer would put today's: unequal bytes
    } else {
        spec.attribute("oiio:ColorSpace", "sRGB");
        spec.attribute("CompressionQuality", 95);
    }
    return spec;
}

/// Rounded here: the library's own conversion may dither or round otherwise from version to version.
std::vector<unsigned char> quantized(const std::vector<float>& values) {
    std::vector<unsigned char> result(values.size());
    std::transform(values.begin(), values.end(), result.begin(), [](float v) {
        return static_cast<unsigned char>(std::lround(255.0f * std::clamp(std::isnan(v) ? 0.0f : v, 0.0f, 1.0f)));
    });
    return result;
}

/// To memory: the PNG writer reports success on a full disk, so bytes are written where errors are seen.
bool encodeBytes(const std::string& format, const RawImage& image,
                 const ImageAttributes& attributes, std::vector<unsigned char>& bytes,
                 std::string& error) {
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("image." + format);
    if (!output || !output->supports("ioproxy")) {
        error = output ? "this OpenImageIO cannot write " + format + " to memory" : OIIO::geterror();
        return false;
    }
    OIIO::Filesystem::IOVecOutput memory(bytes);
    bool done = output->set_ioproxy(&memory) && output->open("image." + format, specOf(format, image, attributes));
    if (done && format == "exr")
        done = output->write_image(OIIO::TypeDesc::FLOAT, image.values.data());
    else if (done)
        done = output->write_image(OIIO::TypeDesc::UINT8, quantized(image.values).data());
    done = output->close() && done;
    if (!done)
        error = output->geterror();
    return done;
}

/// No exception crosses the library's border.
template <class Function>
bool guarded(std::string& error, Function&& function) {
    try {
        return function();
    } catch (const std::exception& e) {
        error = e.what();
        return false;
    }
}

bool decode(const std::string& file, bool linear, RawImage& image, std::string& error) {
    return guarded(error, [&] { return decodeFile(file, linear, image, error); });
}

bool encode(const std::string& format, const RawImage& image,
            const ImageAttributes& attributes, std::vector<unsigned char>& bytes,
            std::string& error) {
    return guarded(error, [&] { return encodeBytes(format, image, attributes, bytes, error); });
}

} // namespace

extern "C" __attribute__((visibility("default"))) ImageCodec eikonalImageCodec() { return {decode, encode}; }

} // namespace eikonal
