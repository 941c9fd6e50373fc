#include "tools/front_ply.h"

#include <algorithm>
#include <bit>
#include <string>
#include <type_traits>

#include <fmt/core.h>

#include "common/output_file.h"
#include "common/physics.h"
#include "tools/program.h"

namespace eikonal {

namespace {

static_assert(std::endian::native == std::endian::little, "values are written as they lie in memory");

std::string headerOf(std::size_t patches) {
    return fmt::format("ply\n"
                       "format binary_little_endian 1.0\n"
                       "comment {} {}: patches of wavefronts, lengths in scene units, irradiance as power per unit area\n"
                       "element vertex {}\n"
                       "property float x\n"
                       "property float y\n"
                       "property float z\n"
                       "element face {}\n"
                       "property list uchar int vertex_indices\n"
                       "property float irradiance_r\n"
                       "property float irradiance_g\n"
                       "property float irradiance_b\n"
                       "property float optical_time\n"
                       "property uchar folded\n"
                       "property uchar red\n"
                       "property uchar green\n"
                       "property uchar blue\n"
                       "end_header\n",
                       kCreator, kVersion, 4 * patches, patches);
}

template <class T>
void append(std::string& bytes, const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Median over the patches of the mean over bands, of those that are lit: a focus does not move it. 1 if none is.
double medianIrradiance(const std::vector<FrontPatch>& patches) {
    std::vector<double> values;
    for (const FrontPatch& patch : patches) {
        const double mean = double(patch.irradiance.r + patch.irradiance.g + patch.irradiance.b) / 3.0;
        if (mean > 0.0) {
            values.push_back(mean);
        }
    }
    if (values.empty()) {
        return 1.0;
    }
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// The irradiance that is `grey` comes out at half the display's light, brighter ones run to white.
glm::vec<3, std::uint8_t> colourOf(const glm::vec3& irradiance, double grey) {
    const glm::dvec3 display = f64::srgbEncoded3(f64::toneReinhard(glm::dvec3(irradiance) / grey));
    return glm::vec<3, std::uint8_t>(glm::round(display * 255.0));
}

void appendFace(std::string& bytes, const FrontPatch& patch, std::size_t index, double grey) {
    append(bytes, std::uint8_t(4));
    for (std::size_t corner = 0; corner < 4; ++corner) {
        append(bytes, std::int32_t(4 * index + corner));
    }
    append(bytes, patch.irradiance);
    append(bytes, float(patch.opticalTime));
    append(bytes, std::uint8_t(patch.folded ? 1 : 0));
    append(bytes, colourOf(patch.irradiance, grey));
}

} // namespace

void writeFrontPly(const std::filesystem::path& path, const std::vector<FrontPatch>& patches) {
    const double grey = medianIrradiance(patches);
    std::string bytes = headerOf(patches.size());
    for (const FrontPatch& patch : patches) {
        for (const glm::vec3& corner : patch.corners) {
            append(bytes, corner);
        }
    }
    for (std::size_t i = 0; i < patches.size(); ++i) {
        appendFace(bytes, patches[i], i, grey);
    }
    writeFile(path, bytes);
}

} // namespace eikonal
