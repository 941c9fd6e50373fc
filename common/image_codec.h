#pragma once
// What the image module offers; it is opened with dlopen, so that only commands with images pay for its 261 libraries.

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <glm/glm.hpp>

namespace eikonal {

/// Named values in the head of an OpenEXR. Matrices are for column vectors, as GLM's are; the file holds them for row vectors.
using ImageAttributes = std::vector<std::pair<std::string, std::variant<std::string, float, glm::mat4>>>;

/// Pixels as they pass between the program and the module: `names.size()` interleaved floats a pixel, from the top.
struct RawImage {
    int width = 0;
    int height = 0;
    std::vector<std::string> names;
    std::vector<float> values;
};

/// Functions of the module. Both return false and set `error` instead of throwing across the library's border.
struct ImageCodec {
    /// Colours of display-referred formats become linear when `linear`.
    bool (*decode)(const std::string& file, bool linear, RawImage& image, std::string& error);
    /// `format` is "exr" (float), "png" or "jpg" (8 bits). The bytes of the whole file.
    bool (*encode)(const std::string& format, const RawImage& image,
                   const ImageAttributes& attributes, std::vector<unsigned char>& bytes,
                   std::string& error);
};

/// Name and type of the module's only symbol.
constexpr const char* kImageCodecSymbol = "eikonalImageCodec";
using ImageCodecFunction = ImageCodec (*)();

} // namespace eikonal
