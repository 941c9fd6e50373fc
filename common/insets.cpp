#include "common/insets.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/compose_layer.h"
#include "common/compose_matter.h"
#include "common/depth.h"
#include "common/error.h"
#include "common/object_bounds.h"

namespace eikonal {
namespace {

/// The object where its own coordinates are the world's.
Object atRest(Object object) {
    object.translate = object.rotate = glm::dvec3(0.0);
    object.scale = 1.0;
    return object;
}

/// Voxels beyond the object's box, over which its boundary fades out as with `voxelize`; at least the band of a sharp one and
/// what differences reach.
int paddingOf(const Scene& scene, const Object& object) {
    if (object.opaque || std::holds_alternative<FieldShape>(object.shape))
        return 2;
    return std::max(int(std::ceil(4.0 * object.smoothVoxels.value_or(scene.domain.smoothVoxels))) + 1, 3);
}

/// The lattice about an object's box, `object.resolution` voxels along its longest side, padding included.
Lattice latticeAround(const Scene& scene, const Object& object, const Bounds& box) {
    const glm::dvec3 extent = box.max - box.min;
    const int padding = paddingOf(scene, object);
    const int inner = *object.resolution - 2 * padding;
    if (inner < 1)
        throw badInput(fmt::format("{}: object.resolution: expected at least {} voxels, of which smoothing takes {} on each "
                                   "side, found {}",
                                   describe(object.whereResolution), 2 * padding + 1, padding, *object.resolution));
    Lattice lattice;
    lattice.voxel = std::max({extent.x, extent.y, extent.z}) / inner;
    constexpr double kRounding = 1e-6;  // voxels: a whole number of voxels stays that number
    const glm::ivec3 covered = glm::max(glm::ivec3(glm::ceil(extent / lattice.voxel - kRounding)), glm::ivec3(1));
    lattice.size = covered + 2 * padding;
    lattice.min = 0.5 * (box.min + box.max) - 0.5 * lattice.extent();
    return lattice;
}

/// Differences at the faces of a lattice are of lower order, and make much of the tail of a boundary: objects are composed on one
/// that is larger by as many voxels as differences reach, which are then cut off.
constexpr int kMargin = 3;

Lattice widened(const Lattice& lattice) {
    return {lattice.min - kMargin * lattice.voxel, lattice.voxel, lattice.size + 2 * kMargin};
}

template <class Value>
DenseGrid<Value> withoutMargin(const DenseGrid<Value>& grid) {
    if (grid.empty())
        return {};
    DenseGrid<Value> inner(grid.size - 2 * kMargin, Value(0));
    for (int k = 0; k < inner.size.z; ++k)
        for (int j = 0; j < inner.size.y; ++j)
            std::copy_n(&grid.at(kMargin, j + kMargin, k + kMargin), inner.size.x, &inner.at(0, j, k));
    return inner;
}

Fields withoutMargin(const Fields& fields, const Lattice& lattice) {
    Fields inner;
    inner.lattice = lattice;
    inner.iorUniform = fields.iorUniform;
    for (DenseGrid<float> Fields::* grid : {&Fields::ior, &Fields::cauchyB, &Fields::anisotropy, &Fields::opaque})
        inner.*grid = withoutMargin(fields.*grid);
    for (DenseGrid<glm::vec3> Fields::* grid : {&Fields::iorGradient, &Fields::cauchyGradient, &Fields::sigmaA, &Fields::sigmaS,
                                                &Fields::anisotropyByBand, &Fields::emission, &Fields::albedo})
        inner.*grid = withoutMargin(fields.*grid);
    inner.interface = withoutMargin(fields.interface);
    return inner;
}

/// The same in all of the object.
bool isEverywhere(const ObjectLayer& layer, const std::string& name, const Quantity& quantity) {
    return quantity.isConstant() && !layer.grid(name);
}

InsetQuantity everywhere(const glm::vec4& value) { return {.everywhere = value, .present = true}; }

/// Values with their gradients by voxel.
std::vector<glm::vec4> withGradients(const DenseGrid<float>& values, const DenseGrid<glm::vec3>& gradients, double voxel) {
    std::vector<glm::vec4> texels;
    texels.reserve(values.values.size());
    for (std::size_t v = 0; v < values.values.size(); ++v)
        texels.emplace_back(gradients.values[v] * float(voxel), values.values[v]);
    return texels;
}

std::vector<glm::vec4> withAlpha(const DenseGrid<glm::vec3>& colours, const DenseGrid<float>& alpha) {
    std::vector<glm::vec4> texels;
    texels.reserve(colours.values.size());
    for (std::size_t v = 0; v < colours.values.size(); ++v)
        texels.emplace_back(colours.values[v], alpha.empty() ? 0.0f : alpha.values[v]);
    return texels;
}

void fillIndex(const ObjectLayer& layer, const Fields& composed, InsetGrids& grids) {
    const Object& object = *layer.object;
    auto& of = grids.quantities;
    if (!layer.changesIndex || composed.ior.empty())
        return;
    const double voxel = grids.lattice.voxel;
    const DenseGrid<glm::vec3> gradient = gradientOf(layer.extent.index, voxel);
    of[gpu::kInsetCoverage] = {
        .varying = withGradients(withoutMargin(layer.extent.index), withoutMargin(gradient), voxel), .present = true};
    of[gpu::kInsetIndex] = everywhere(glm::vec4(float(object.ior.constant.x)));
    if (!isEverywhere(layer, "ior", object.ior))
        of[gpu::kInsetIndex].varying = withGradients(composed.ior, composed.iorGradient, voxel);
    if (!composed.cauchyB.empty()) {
        of[gpu::kInsetDispersion] = everywhere(glm::vec4(float(object.cauchyB)));
        if (tellsMatterByIndex(layer))
            of[gpu::kInsetDispersion].varying = withGradients(composed.cauchyB, composed.cauchyGradient, voxel);
    }
    of[gpu::kInsetSurface] = everywhere(
        glm::vec4(glm::vec3(object.reflectionTint), object.surface == Surface::kRough ? float(object.roughness) : 0.0f));
    grids.boundary = composed.interface;
}

void fillMatter(const ObjectLayer& layer, const Fields& composed, InsetGrids& grids) {
    const Object& object = *layer.object;
    const auto fill = [&](int quantity, const std::string& name, const Quantity& own, const DenseGrid<glm::vec3>& grid) {
        if (grid.empty())
            return;
        grids.quantities[std::size_t(quantity)] = everywhere(glm::vec4(glm::vec3(own.constant), 0.0f));
        if (!isEverywhere(layer, name, own))
            grids.quantities[std::size_t(quantity)].varying = withAlpha(grid, {});
    };
    fill(gpu::kInsetAbsorption, "absorption", object.absorption, composed.sigmaA);
    fill(gpu::kInsetScattering, "scattering", object.scattering, composed.sigmaS);
    fill(gpu::kInsetEmission, "emission", object.emission, composed.emission);
    InsetQuantity& scattering = grids.quantities[gpu::kInsetScattering];
    scattering.everywhere.w = float(object.anisotropy.constant.x);
    if (scattering.present && (!scattering.varying.empty() || !isEverywhere(layer, "anisotropy", object.anisotropy)))
        scattering.varying = withAlpha(composed.sigmaS, composed.anisotropy);
    if (!composed.anisotropyByBand.empty()) {
        grids.quantities[gpu::kInsetAnisotropy] = everywhere(glm::vec4(glm::vec3(object.anisotropy.constant), 1.0f));
        if (!isEverywhere(layer, "anisotropy", object.anisotropy))
            grids.quantities[gpu::kInsetAnisotropy].varying = withAlpha(composed.anisotropyByBand, {});
    }
}

void fillOpaque(const ObjectLayer& layer, const Fields& composed, InsetGrids& grids) {
    if (composed.opaque.empty())
        return;
    const Object& object = *layer.object;
    const auto* plane = std::get_if<PlaneShape>(&object.shape);
    const bool isPlain = !layer.grid("opaque") && !layer.grid("albedo") && !(plane && plane->checker);
    InsetQuantity& opaque = grids.quantities[gpu::kInsetOpaque];
    opaque = everywhere(glm::vec4(glm::vec3(object.albedo), 0.0f));
    if (!isPlain)
        opaque.varying = withAlpha(composed.albedo, composed.opaque);
}

/// Least and greatest index of what the object covers, from the index times its coverage.
void boundIor(const DenseGrid<float>& coverage, const DenseGrid<float>& composedIor, InsetGrids& grids) {
    constexpr float kHalf = 0.5f;  // below it the quotient is less certain, and its values are met elsewhere
    const InsetQuantity& index = grids.quantities[gpu::kInsetIndex];
    grids.iorMin = grids.iorMax = index.everywhere.w;
    if (index.varying.empty())
        return;
    bool any = false;
    for (std::size_t v = 0; v < composedIor.values.size(); ++v) {
        if (coverage.values[v] < kHalf)
            continue;
        const float ior = composedIor.values[v] / coverage.values[v];
        grids.iorMin = any ? std::min(grids.iorMin, ior) : ior;
        grids.iorMax = any ? std::max(grids.iorMax, ior) : ior;
        any = true;
    }
}

/// The object over nothing: what its grids hold is times its coverage.
Fields overNothing(const ObjectLayer& layer, const Lattice& lattice) {
    Fields fields;
    fields.lattice = lattice;
    fields.ior = DenseGrid<float>(lattice.size, 0.0f);
    fields.interface = DenseGrid<unsigned char>(lattice.size, 0);
    composeLayer(layer, fields);
    finishFields(fields);
    return fields;
}

InsetGrids gridsOf(const Scene& scene, const Object& object, std::size_t index) {
    const Object resting = atRest(object);
    InsetGrids grids;
    grids.lattice = latticeAround(scene, resting, boundsOf(scene, resting));
    const Lattice wide = widened(grids.lattice);
    const ObjectLayer layer = layerOf(scene, resting, index, wide);
    const Fields composed = withoutMargin(overNothing(layer, wide), grids.lattice);
    grids.depth = withoutMargin(layer.extent.depth);
    grids.displaces = !object.opaque;
    fillIndex(layer, composed, grids);
    fillMatter(layer, composed, grids);
    fillOpaque(layer, composed, grids);
    if (grids.has(gpu::kInsetCoverage))
        boundIor(withoutMargin(layer.extent.index), composed.ior, grids);
    grids.pyramid = fieldPyramidOf(composed);
    boundArea(sharesOf(grids.depth), grids.pyramid);
    return grids;
}

Inset placed(const Object& object, std::size_t index, std::shared_ptr<const InsetGrids> grids) {
    return {labelOf(object, index), std::move(grids), object.worldFromLocal(), object.scale};
}

/// The indices of the objects of a scene that have a resolution.
std::vector<std::size_t> resolvedObjects(const Scene& scene) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (scene.objects[i].resolution)
            indices.push_back(i);
    return indices;
}

void requireNoOverlap(const Scene& scene, std::size_t earlier, std::size_t later) {
    const Object& inset = scene.objects[earlier];
    const Object& other = scene.objects[later];
    const Lattice lattice = latticeAround(scene, inset, boundsOf(scene, inset));
    const double tail = paddingOf(scene, other) * latticeOf(scene.domain).voxel;
    if (!mayOverlap(inset, {lattice.min, lattice.max()}, other, boundsOf(scene, other), tail))
        return;
    throw badInput(fmt::format("{}: {}: expected objects without a resolution before those with one that they may overlap, "
                               "found it after {}; list it earlier, or give it a resolution too",
                               describe(other.where), labelOf(other, later), labelOf(inset, earlier)));
}

} // namespace

std::size_t InsetGrids::bytes() const {
    std::size_t sum = depth.values.size() * sizeof(float) + boundary.values.size() +
                      pyramid.bricks.values.size() * sizeof(FieldBrick);
    for (const InsetQuantity& quantity : quantities)
        sum += quantity.varying.size() * sizeof(glm::vec4);
    return sum;
}

std::vector<Inset> composeInsets(const Scene& scene) {
    const std::vector<std::size_t> indices = resolvedObjects(scene);
    if (indices.size() > gpu::kMostInsets)
        throw badInput(fmt::format("{}: expected at most {} objects with a resolution, found {}", scene.source,
                                   int(gpu::kMostInsets), indices.size()));
    std::vector<Inset> insets;
    for (const std::size_t i : indices)
        insets.push_back(placed(scene.objects[i], i, std::make_shared<const InsetGrids>(gridsOf(scene, scene.objects[i], i))));
    return insets;
}

std::vector<Inset> movedInsets(const Scene& scene, std::vector<Inset> insets) {
    const std::vector<std::size_t> indices = resolvedObjects(scene);
    for (std::size_t i = 0; i < insets.size(); ++i)
        insets[i] = placed(scene.objects[indices[i]], indices[i], insets[i].grids);
    return insets;
}

void requireInsetsComeLast(const Scene& scene) {
    for (const std::size_t earlier : resolvedObjects(scene))
        for (std::size_t later = earlier + 1; later < scene.objects.size(); ++later)
            if (!scene.objects[later].resolution)
                requireNoOverlap(scene, earlier, later);
}

double voxelOf(const Inset& inset) { return inset.scale * inset.grids->lattice.voxel; }

bool reachesBeyond(const Inset& inset, const Lattice& domain) {
    const Lattice& lattice = inset.grids->lattice;
    constexpr double kSlack = 1e-6;  // voxels of the domain
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::dvec3 at(inset.worldFromLocal * glm::dvec4(glm::mix(lattice.min, lattice.max(), side), 1.0));
        const glm::dvec3 beyond = glm::max(domain.min - at, at - domain.max());
        if (std::max({beyond.x, beyond.y, beyond.z}) > kSlack * domain.voxel)
            return true;
    }
    return false;
}

} // namespace eikonal
