#include "viewer/clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/device_frame.h"
#include "common/inset_bricks.h"
#include "shaders/shared/brick.h"

namespace eikonal::viewer {

namespace {

/// Whether a ray must look at every step: it may be bent, cross a boundary, be stopped or pass matter that has to be sampled.
bool holdsRays(const FieldBrick& brick, const EffectSet& effects, double negligible, bool lit) {
    const bool passesMatter = effects.has(Effect::kAbsorption) || effects.has(Effect::kScattering) || effects.has(Effect::kEmission);
    const float gradientMax =
        brick.gradientMax + (effects.has(Effect::kDispersion) ? brick.dispersedGradientMax : 0.0f);
    return (effects.has(Effect::kRefraction) && (gradientMax > negligible || brick.boundary)) ||
           (effects.has(Effect::kOpaque) && brick.opaque) ||
           (passesMatter && !brick.evenMatter) || (lit && brick.scatters);
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

/// Of bricks to the next obstacle, or of an obstacle to the next place without.
unsigned char texelOf(unsigned char toObstacle, unsigned char toOpening) {
    const auto most = [](unsigned char distance) { return std::min<int>(distance, gpu::kNoClearance - 1); };
    return static_cast<unsigned char>(gpu::kNoClearance + (toObstacle > 0 ? most(toObstacle) : -most(toOpening)));
}

} // namespace

Clearance::Clearance(const gpu::Context& context, const Fields& fields, const EffectSet& effects,
                     const FlightRules& rules)
    : effects_(effects), rules_(rules) {
    const std::vector<unsigned char> texels = lookAt(fields);
    const bool isFull = std::all_of(texels.begin(), texels.end(), [](unsigned char texel) { return texel < gpu::kNoClearance; });
    if (isFull && fields.insets.empty()) return;  // insets may go elsewhere, and kernels stay
    texture_.emplace(context, gpu::TexelFormat::kR8, (fields.lattice.size + kBrickVoxels - 1) / kBrickVoxels, "clearance");
    texture_->upload(texels.data());
}

std::vector<unsigned char> Clearance::lookAt(const Fields& fields) {
    FieldPyramid pyramid = fieldPyramidOf(fields);
    negligibleGradient_ = negligibleGradient(pyramid, rules_.tolerance);
    addInsets(fields, pyramid);
    const Box content = contentOf(pyramid, effects_);
    contentMin_ = deviceFromWorld(fields.lattice, content.min);
    contentMax_ = deviceFromWorld(fields.lattice, content.max);
    const auto isObstacle = [&](const FieldBrick& brick) {
        return holdsRays(brick, effects_, negligibleGradient_, rules_.lit);
    };
    const auto toObstacles = clearanceOf(pyramid, isObstacle);
    const auto toOpenings = clearanceOf(pyramid, [&](const FieldBrick& brick) { return !isObstacle(brick); });
    std::vector<unsigned char> texels(pyramid.bricks.values.size());
    std::transform(toObstacles.values.begin(), toObstacles.values.end(), toOpenings.values.begin(), texels.begin(), texelOf);
    return texels;
}

void Clearance::move(const Fields& fields) {
    const std::vector<unsigned char> texels = lookAt(fields);
    if (texture_) texture_->upload(texels.data());
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
