#include "common/gpu_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "common/cubic_spline.h"
#include "common/device_frame.h"
#include "common/insets.h"
#include "common/physics.h"
#include "common/spectral_fields.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/depth_range.h"

namespace eikonal {

namespace {

gpu::DomainBlock domainBlock(const Fields& fields) {
    gpu::DomainBlock block{};
    block.min = glm::vec3(deviceFromWorld(fields.lattice, fields.lattice.min));
    block.voxel = float(fields.lattice.voxel);
    block.max = glm::vec3(deviceFromWorld(fields.lattice, fields.lattice.max()));
    block.ior = fields.iorUniform;
    block.scale = glm::vec3(1.0 / fields.lattice.extent());
    block.size = fields.lattice.size;
    return block;
}

template <class Value>
void require(const DenseGrid<Value>& grid, std::string_view name) {
    if (grid.empty()) throw std::logic_error("an effect is on whose grid is missing: " + std::string(name));
}

/// What stands on the domain's lattice for a grid that only insets call for.
template <class Value>
DenseGrid<Value> oneVoxel(const Value& value) {
    return DenseGrid<Value>(glm::ivec3(1), value);
}

gpu::Texture3D interfaceTexture(const gpu::Context& context, const DenseGrid<unsigned char>& band) {
    gpu::Texture3D texture(context, gpu::TexelFormat::kR8, band.size, "interface");
    texture.upload(band.values.data());
    return texture;
}

unsigned char asByte(float share) { return static_cast<unsigned char>(std::lround(255.0f * share)); }

gpu::Texture3D surfaceTexture(const gpu::Context& context, const Fields& fields) {
    const bool onlyInInsets = fields.reflectionTint.empty() && fields.roughness.empty();
    const glm::ivec3 size = onlyInInsets ? glm::ivec3(1) : fields.lattice.size;
    gpu::Texture3D texture(context, gpu::TexelFormat::kRgba8, size, "surface");
    std::vector<std::array<unsigned char, 4>> texels(onlyInInsets ? 1 : fields.lattice.count(), {255, 255, 255, 0});
    for (std::size_t i = 0; i < texels.size(); ++i) {
        if (!fields.reflectionTint.empty()) {
            const glm::vec3& tint = fields.reflectionTint.values[i];
            std::transform(&tint.x, &tint.x + 3, texels[i].begin(), asByte);
        }
        if (!fields.roughness.empty()) texels[i][3] = asByte(fields.roughness.values[i]);
    }
    texture.upload(texels.data());
    return texture;
}

/// Each texel four coefficients of a row (shaders/fields/spline.glsl).
gpu::Texture3D splineTexture(const gpu::Context& context, const DenseGrid<float>& coefficients) {
    const glm::ivec3 size(coefficients.size.x - 3, coefficients.size.y, coefficients.size.z);
    std::vector<glm::vec4> texels;
    texels.reserve(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            const float* row = &coefficients.at(0, j, k);
            for (int i = 0; i < size.x; ++i) texels.emplace_back(row[i], row[i + 1], row[i + 2], row[i + 3]);
        }
    }
    gpu::Texture3D texture(context, gpu::TexelFormat::kRgba32f, size, "optics");
    texture.upload(texels.data());
    return texture;
}

bool isZero(const DenseGrid<float>& grid) {
    return std::all_of(grid.values.begin(), grid.values.end(), [](float value) { return value == 0.0f; });
}

bool differsByBand(const Fields& fields) {
    return !fields.anisotropyByBand.empty() || std::any_of(fields.insets.begin(), fields.insets.end(), [](const Inset& inset) {
        return inset.grids->has(gpu::kInsetAnisotropy);
    });
}

/// g of each band on the domain's lattice, where bands differ there or in an inset.
DenseGrid<glm::vec3> anisotropyByBand(const Fields& fields) {
    if (!fields.anisotropyByBand.empty()) return fields.anisotropyByBand;
    if (fields.anisotropy.empty()) return oneVoxel(glm::vec3(0.0f));
    DenseGrid<glm::vec3> grid(fields.anisotropy.size, glm::vec3(0.0f));
    std::transform(fields.anisotropy.values.begin(), fields.anisotropy.values.end(), grid.values.begin(),
                   [](float g) { return glm::vec3(g); });
    return grid;
}

/// Whether nothing scatters but evenly.
bool isIsotropic(const Fields& fields) {
    const auto forward = [](const glm::vec4& scattering) { return scattering.a != 0.0f; };
    return isZero(fields.anisotropy) && std::none_of(fields.insets.begin(), fields.insets.end(), [&](const Inset& inset) {
        const InsetQuantity& held = inset.grids->quantities[gpu::kInsetScattering];
        return held.present && (forward(held.everywhere) || std::any_of(held.varying.begin(), held.varying.end(), forward));
    });
}

gpu::Texture3D greyTexture(const gpu::Context& context, const DenseGrid<glm::vec3>& grid, std::string_view label) {
    gpu::Texture3D texture(context, gpu::TexelFormat::kR32f, grid.size, label);
    std::vector<float> texels(grid.values.size());
    std::transform(grid.values.begin(), grid.values.end(), texels.begin(), [](const glm::vec3& value) { return value.x; });
    texture.upload(texels.data());
    texture.showGrey();
    return texture;
}

} // namespace

gpu::Texture3D colourTexture(const gpu::Context& context, const DenseGrid<glm::vec3>& grid,
                             const DenseGrid<float>& alpha, std::string_view label) {
    if (isGrey(grid) && isZero(alpha)) return greyTexture(context, grid, label);
    gpu::Texture3D texture(context, gpu::TexelFormat::kRgba32f, grid.size, label);
    std::vector<glm::vec4> texels(grid.values.size());
    for (std::size_t i = 0; i < texels.size(); ++i) {
        texels[i] = glm::vec4(grid.values[i], alpha.empty() ? 0.0f : alpha.values[i]);
    }
    texture.upload(texels.data());
    return texture;
}

GpuFields::GpuFields(const gpu::Context& context, const Fields& fields, const EffectSet& effects, Interpolation interpolation)
    : cauchyOverRefractivity_(cauchyOverRefractivity(fields)), block_(domainBlock(fields)),
      domain_(context, sizeof block_, "domain"), defines_(effects.defines()) {
    domain_.upload(block_);
    if (!context.limits().exactLinearFiltering) defines_.push_back("MANUAL_FILTERING");
    const auto add = [&](Effect effect, int unit, std::string_view label, const DenseGrid<glm::vec3>& grid,
                         const DenseGrid<float>& alpha, float alphaOfNothing = 0.0f) {
        if (!effects.has(effect)) return;
        const bool onlyInInsets = grid.empty() && !fields.insets.empty();
        if (!onlyInInsets) require(grid, label);
        textures_.push_back({unit, onlyInInsets ? colourTexture(context, oneVoxel(glm::vec3(0.0f)), oneVoxel(alphaOfNothing), label)
                                                : colourTexture(context, grid, alpha, label)});
    };
    if (effects.has(Effect::kRefraction) && interpolation == Interpolation::kCubic && !fields.ior.empty()) {
        textures_.push_back({gpu::kUnitOptics, splineTexture(context, splineCoefficients(fields.ior))});
        defines_.push_back("CUBIC_INTERPOLATION");
    } else {
        add(Effect::kRefraction, gpu::kUnitOptics, "optics", fields.iorGradient, fields.ior, fields.iorUniform);
    }
    if (!cauchyOverRefractivity_) {
        add(Effect::kDispersion, gpu::kUnitDispersion, "dispersion", fields.cauchyGradient, fields.cauchyB);
    } else if (effects.has(Effect::kDispersion)) {
        defines_.push_back("DISPERSION_BY_REFRACTIVITY");
    }
    if (effects.has(Effect::kReflection)) {
        const bool onlyInInsets = fields.interface.empty() && !fields.insets.empty();
        if (!onlyInInsets) require(fields.interface, "interface");
        const auto& band = onlyInInsets ? oneVoxel<unsigned char>(0) : fields.interface;
        textures_.push_back({gpu::kUnitInterface, interfaceTexture(context, band)});
    }
    if (effects.has(Effect::kTint) || effects.has(Effect::kRoughness)) {
        textures_.push_back({gpu::kUnitSurface, surfaceTexture(context, fields)});
    }
    add(Effect::kAbsorption, gpu::kUnitSigmaA, "sigma_a", fields.sigmaA, {});
    add(Effect::kScattering, gpu::kUnitSigmaS, "sigma_s", fields.sigmaS, fields.anisotropy);
    if (effects.has(Effect::kScattering) && isIsotropic(fields)) defines_.push_back("ISOTROPIC_SCATTERING");
    if (effects.has(Effect::kScattering) && differsByBand(fields)) {
        textures_.push_back({gpu::kUnitAnisotropy, colourTexture(context, anisotropyByBand(fields), {}, "anisotropy")});
        defines_.push_back("ANISOTROPY_BY_BAND");
    }
    add(Effect::kEmission, gpu::kUnitEmission, "emission", fields.emission, {});
    add(Effect::kOpaque, gpu::kUnitOpaque, "opaque", fields.albedo, fields.opaque, gpu::kLeastDepth);
    if (!fields.insets.empty()) {
        insets_.emplace(context, fields, effects);
        defines_.push_back("INSETS");
    }
}

void GpuFields::moveInsets(const Fields& fields) {
    if (insets_) insets_->move(fields);
}

void GpuFields::setWavelength(double micrometres) {
    block_.dispersion = float(f64::dispersionTerm(micrometres) * cauchyOverRefractivity_.value_or(1.0));
    domain_.upload(block_);
}

void GpuFields::bind() const {
    domain_.bindUniform(gpu::kUniformDomain);
    for (const auto& bound : textures_) bound.texture.bind(GLuint(bound.unit));
    if (insets_) insets_->bind();
}

std::vector<std::pair<std::string, std::size_t>> GpuFields::textures() const {
    std::vector<std::pair<std::string, std::size_t>> rows;
    for (const auto& bound : textures_) rows.emplace_back(bound.texture.label(), bound.texture.bytes());
    if (insets_) {
        const auto ofInsets = insets_->textures();
        rows.insert(rows.end(), ofInsets.begin(), ofInsets.end());
    }
    return rows;
}

} // namespace eikonal
