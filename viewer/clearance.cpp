#include "viewer/clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/device_frame.h"

namespace eikonal::viewer {

namespace {

/// Whether a ray must look at every step: it may be bent, cross a boundary or be stopped.
bool holdsRays(const FieldBrick& brick, const EffectSet& effects, double negligible) {
    const float gradientMax =
        brick.gradientMax + (effects.has(Effect::kDispersion) ? brick.dispersedGradientMax : 0.0f);
    return (effects.has(Effect::kRefraction) && (gradientMax > negligible || brick.boundary)) ||
           (effects.has(Effect::kOpaque) && brick.opaque);
}

/// Optical lengths are single precision: they do not tell such an index from 1.
bool isVacuum(const FieldBrick& brick, const EffectSet& effects) {
    constexpr float kNoIndex = 1e-6f;
    const bool disperses = effects.has(Effect::kDispersion) && brick.dispersionMax >= kNoIndex;
    return !brick.matter && !brick.opaque && !brick.boundary && !disperses && std::abs(brick.iorMin - 1.0f) < kNoIndex &&
           std::abs(brick.iorMax - 1.0f) < kNoIndex;
}

struct Box {
    glm::dvec3 min{std::numeric_limits<double>::infinity()}, max{-std::numeric_limits<double>::infinity()};
};

/// The box of all bricks that are not vacuum; where there is none, a point that no ray of the domain meets.
Box contentOf(const FieldPyramid& pyramid, const EffectSet& effects) {
    const Lattice& lattice = pyramid.lattice;
    const double edge = kBrickVoxels * lattice.voxel;
    Box box;
    std::size_t b = 0;
    for (int k = 0; k < pyramid.bricks.size.z; ++k) {
        for (int j = 0; j < pyramid.bricks.size.y; ++j) {
            for (int i = 0; i < pyramid.bricks.size.x; ++i) {
                if (isVacuum(pyramid.bricks.values[b++], effects)) continue;
                const glm::dvec3 low = lattice.min + edge * glm::dvec3(i, j, k);
                box.min = glm::min(box.min, low);
                box.max = glm::max(box.max, low + edge);
            }
        }
    }
    if (box.max.x < box.min.x) box.min = box.max = lattice.max() + lattice.extent();
    return box;
}

gpu::Texture3D textureOf(const gpu::Context& context, const DenseGrid<unsigned char>& straight,
                         const DenseGrid<unsigned char>& even) {
    std::vector<unsigned char> texels;
    texels.reserve(2 * straight.values.size());
    for (std::size_t b = 0; b < straight.values.size(); ++b) {
        texels.push_back(straight.values[b]);
        texels.push_back(even.values[b]);
    }
    gpu::Texture3D texture(context, gpu::TexelFormat::kRg8, straight.size, "clearance");
    texture.upload(texels.data());
    return texture;
}

} // namespace

Clearance::Clearance(const gpu::Context& context, const Fields& fields, const EffectSet& effects,
                     const FlightRules& rules) {
    const FieldPyramid pyramid = fieldPyramidOf(fields);
    negligibleGradient_ = negligibleGradient(pyramid, rules.tolerance);
    const Box content = contentOf(pyramid, effects);
    contentMin_ = deviceFromWorld(fields.lattice, content.min);
    contentMax_ = deviceFromWorld(fields.lattice, content.max);
    const auto straight = clearanceOf(pyramid, [&](const FieldBrick& brick) {
        return holdsRays(brick, effects, negligibleGradient_);
    });
    if (std::all_of(straight.values.begin(), straight.values.end(), [](auto distance) { return distance == 0; })) return;
    const auto even = clearanceOf(pyramid, [&](const FieldBrick& brick) {
        return !brick.evenMatter || (rules.lit && brick.scatters);
    });
    texture_ = textureOf(context, straight, even);
}

void Clearance::configure(gpu::ViewBlock& view) const {
    view.negligibleGradient = float(negligibleGradient_);
    view.contentMin = glm::vec3(contentMin_);
    view.contentMax = glm::vec3(contentMax_);
}

void Clearance::bind() const {
    if (texture_) texture_->bind(gpu::kUnitClearance);
}

std::vector<std::string> Clearance::defines() const {
    return texture_ ? std::vector<std::string>{"STRAIGHT_FLIGHTS"} : std::vector<std::string>{};
}

std::vector<std::pair<std::string, std::size_t>> Clearance::textures() const {
    if (!texture_) return {};
    return {{texture_->label(), texture_->bytes()}};
}

} // namespace eikonal::viewer
