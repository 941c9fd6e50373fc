#include "common/compose_matter.h"

#include <algorithm>
#include <cmath>

#include "common/compose_terms.h"
#include "common/depth.h"
#include "common/volume_sampling.h"

namespace eikonal {
namespace {

/// So written that full coverage gives the object's value to the bit: given grids are copied, not approximated.
double mixed(double before, double after, double coverage) { return (1.0 - coverage) * before + coverage * after; }

glm::vec3 mixed(const glm::vec3& before, const glm::dvec3& after, double coverage) {
    return glm::vec3((1.0 - coverage) * glm::dvec3(before) + coverage * after);
}

double mean(const glm::dvec3& bands) { return (bands.x + bands.y + bands.z) / 3.0; }

template <class Value>
void ensure(DenseGrid<Value>& grid, const Lattice& lattice, const Value& fill) {
    if (grid.empty())
        grid = DenseGrid<Value>(lattice.size, fill);
}

bool bringsNothing(const ObjectLayer& layer, const std::string& name, const Quantity& quantity) {
    return quantity.isZero() && !layer.grid(name);
}

auto areaOf(const ObjectLayer& layer) {
    return [&layer](std::size_t voxel) { return layer.extent.areaAt(voxel); };
}

void composeBands(const ObjectLayer& layer, const Lattice& lattice, const Term& term, DenseGrid<glm::vec3>& grid) {
    if (grid.empty() && bringsNothing(layer, term.name, *term.quantity))
        return;
    ensure(grid, lattice, glm::vec3(0.0f));
    forCovered(layer, lattice, std::array{term}, areaOf(layer),
               [&](std::size_t voxel, double coverage, const auto& values, const glm::dvec3&) {
                   grid.values[voxel] = mixed(grid.values[voxel], values[0], coverage);
               });
}

double meanBy(double before, double g, double added, double gAdded) {
    return before + added > 0.0 ? (before * g + added * gAdded) / (before + added) : g;
}

bool differs(const glm::dvec3& bands) { return bands.x != bands.y || bands.y != bands.z; }

/// Before what it belongs to is added to the scattering.
void composeAnisotropyByBand(const glm::vec3& sigmaS, const glm::dvec3& added, const glm::dvec3& gAdded, double coverage,
                             glm::vec3& g) {
    for (int band = 0; band < 3; ++band)
        g[band] = float(meanBy((1.0 - coverage) * double(sigmaS[band]), g[band], coverage * added[band], gAdded[band]));
}

/// g is averaged with the scattering that it belongs to as weight, which keeps the mean cosine of what is scattered.
void composeScattering(const ObjectLayer& layer, Fields& fields) {
    const Object& object = *layer.object;
    if (fields.sigmaS.empty() && bringsNothing(layer, "scattering", object.scattering))
        return;
    ensure(fields.sigmaS, fields.lattice, glm::vec3(0.0f));
    ensure(fields.anisotropy, fields.lattice, 0.0f);
    if (fields.anisotropyByBand.empty() && differs(object.anisotropy.constant)) {
        fields.anisotropyByBand = DenseGrid<glm::vec3>(fields.lattice.size, glm::vec3(0.0f));
        std::transform(fields.anisotropy.values.begin(), fields.anisotropy.values.end(), fields.anisotropyByBand.values.begin(),
                       [](float g) { return glm::vec3(g); });
    }
    const std::array terms{notNegative("scattering", object.scattering), anisotropyTerm(object.anisotropy)};
    forCovered(layer, fields.lattice, terms, areaOf(layer),
               [&](std::size_t voxel, double coverage, const auto& values, const glm::dvec3&) {
                   glm::vec3& sigmaS = fields.sigmaS.values[voxel];
                   float& g = fields.anisotropy.values[voxel];
                   if (!fields.anisotropyByBand.empty())
                       composeAnisotropyByBand(sigmaS, values[0], values[1], coverage, fields.anisotropyByBand.values[voxel]);
                   g = float(meanBy((1.0 - coverage) * mean(sigmaS), g, coverage * mean(values[0]), values[1].x));
                   sigmaS = mixed(sigmaS, values[0], coverage);
               });
}

glm::dvec3 checkerAt(const Checker& checker, const glm::dvec3& local) {
    const auto cell = [&](double x) { return std::int64_t(std::floor(x / checker.cell)); };
    return (cell(local.x) + cell(local.z)) % 2 == 0 ? checker.a : checker.b;
}

/// A grid of albedos stands alone unless the scene gives a constant besides.
Quantity albedoOf(const Object& object) {
    Quantity albedo;
    albedo.constant = object.albedo;
    albedo.given = object.albedo != Object{}.albedo;
    return albedo;
}

/// Where opaque matter lies over other such, each has its share of the voxel.
void composeAlbedo(const ObjectLayer& layer, Fields& fields) {
    const Object& object = *layer.object;
    Quantity opaque;
    opaque.constant = glm::dvec3(object.opaque ? 1.0 : 0.0);
    opaque.given = object.opaque;
    const Quantity albedo = albedoOf(object);
    const auto* plane = std::get_if<PlaneShape>(&object.shape);
    const std::array terms{notNegative("opaque", opaque), notNegative("albedo", albedo)};
    forCovered(layer, fields.lattice, terms, areaOf(layer),
               [&](std::size_t voxel, double coverage, const auto& values, const glm::dvec3& local) {
                   const double added = coverage * std::min(values[0].x, 1.0);
                   const double kept = (1.0 - coverage) * (1.0 - freeShareAt(fields.opaque, voxel));
                   const glm::dvec3 color = plane && plane->checker ? checkerAt(*plane->checker, local) : values[1];
                   glm::vec3& before = fields.albedo.values[voxel];
                   if (kept + added > 0.0)
                       before = mixed(before, color, added / (kept + added));
               });
}

DenseGrid<float> depthOf(const Extent& extent) {
    return extent.knowsDistance ? extent.depth : depthFromShares(extent.depth);
}

/// Values continue into voxels without weight as the mean over the neighbours that have some.
template <class Value, class HasWeight>
void spreadByOneVoxel(DenseGrid<Value>& grid, const HasWeight& hasWeight) {
    const DenseGrid<Value> source = grid;
    const glm::ivec3 size = grid.size;
    tbb::parallel_for(0, size.z, [&](int k) {
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                if (hasWeight(source.offset(i, j, k)))
                    continue;
                Value sum(0.0f);
                int count = 0;
                for (int n = 0; n < 27; ++n) {
                    const glm::ivec3 v = glm::ivec3(i, j, k) + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1;
                    const bool within = glm::all(glm::greaterThanEqual(v, glm::ivec3(0))) && glm::all(glm::lessThan(v, size));
                    if (within && hasWeight(source.offset(v.x, v.y, v.z))) {
                        sum += source.at(v);
                        ++count;
                    }
                }
                if (count > 0)
                    grid.at(i, j, k) = sum / float(count);
            }
    });
}

bool allZero(const DenseGrid<glm::vec3>& grid) {
    return std::all_of(grid.values.begin(), grid.values.end(), [](const glm::vec3& v) { return v == glm::vec3(0.0f); });
}

bool allZero(const DenseGrid<float>& grid) {
    return std::all_of(grid.values.begin(), grid.values.end(), [](float v) { return v == 0.0f; });
}

/// How much of each voxel disperses: its refractivity |n - 1| as a share of the strongest. In a boundary between vacuum and
/// one glass that is the coverage by which the given index was composed.
DenseGrid<float> matterByIndex(const ObjectLayer& layer, const Lattice& lattice) {
    DenseGrid<float> matter(lattice.size, 0.0f);
    forCovered(layer, lattice, std::array{iorTerm(layer.object->ior)},
               [&](std::size_t voxel) { return layer.extent.indexAt(voxel); },
               [&](std::size_t voxel, double, const auto& values, const glm::dvec3&) {
                   matter.values[voxel] = float(std::abs(values[0].x - 1.0));
               });
    const float strongest = *std::max_element(matter.values.begin(), matter.values.end());
    for (float& share : matter.values)
        share = strongest > 0.0f ? share / strongest : 0.0f;
    return matter;
}

/// One grid where bands do not differ after all; else the other holds what is farthest from scattering evenly.
void finishAnisotropy(Fields& fields) {
    const auto isScattering = [&](std::size_t v) { return fields.sigmaS.values[v] != glm::vec3(0.0f); };
    spreadByOneVoxel(fields.anisotropy, isScattering);
    auto& byBand = fields.anisotropyByBand.values;
    if (byBand.empty())
        return;
    spreadByOneVoxel(fields.anisotropyByBand, isScattering);
    std::transform(byBand.begin(), byBand.end(), fields.anisotropy.values.begin(), [](const glm::vec3& g) {
        return *std::max_element(&g.x, &g.x + 3, [](float a, float b) { return std::abs(a) < std::abs(b); });
    });
    if (std::none_of(byBand.begin(), byBand.end(), [](const glm::vec3& g) { return differs(glm::dvec3(g)); }))
        fields.anisotropyByBand = {};
}

void finishIndex(Fields& fields) {
    const auto [low, high] = std::minmax_element(fields.ior.values.begin(), fields.ior.values.end());
    fields.iorUniform = *low;
    if (*high - *low < 1e-9f) {
        fields.ior = {};
    } else {
        fields.iorGradient = gradientOf(fields.ior, fields.lattice.voxel);
    }
    if (allZero(fields.cauchyB)) {
        fields.cauchyB = {};
    } else {
        fields.cauchyGradient = gradientOf(fields.cauchyB, fields.lattice.voxel);
    }
}

} // namespace

bool tellsMatterByIndex(const ObjectLayer& layer) {
    return layer.extent.boundaryIsGiven || std::holds_alternative<FieldShape>(layer.object->shape);
}

void composeLayer(const ObjectLayer& layer, Fields& fields) {
    composeDispersion(layer, fields);
    composeIndex(layer, fields);
    composeSurface(layer, fields);
    composeMedia(layer, fields);
    composeOpaque(layer, fields);
}

void composeIndex(const ObjectLayer& layer, Fields& fields) {
    if (!layer.changesIndex)
        return;
    constexpr double kBuried = 0.997, kLeastContrast = 1e-4;  // below it the reflectance is under 1e-9
    const Extent& extent = layer.extent;
    const auto inBoundary = [&](std::size_t voxel) {
        return !extent.boundary.empty() && extent.boundary.values[voxel] != 0;
    };
    // The band of a sharp boundary reaches into voxels that the object does not touch.
    const auto coverage = [&](std::size_t voxel) {
        return std::max(extent.indexAt(voxel), inBoundary(voxel) ? 2.0 * kNoCoverage : 0.0);
    };
    forCovered(layer, fields.lattice, std::array{iorTerm(layer.object->ior)}, coverage,
               [&](std::size_t voxel, double, const auto& values, const glm::dvec3&) {
                   float& n = fields.ior.values[voxel];
                   const double covered = extent.indexAt(voxel);
                   const double contrast = std::abs(values[0].x - double(n));
                   unsigned char& marked = fields.interface.values[voxel];
                   if (covered >= kBuried)
                       marked = 0;
                   if (inBoundary(voxel) && (extent.boundaryIsGiven || contrast > kLeastContrast))
                       marked = 255;
                   n = float(mixed(double(n), values[0].x, covered));
               });
}

void composeSurface(const ObjectLayer& layer, Fields& fields) {
    if (!layer.changesIndex || layer.extent.boundary.empty())
        return;
    const Object& object = *layer.object;
    const bool rough = object.surface == Surface::kRough;
    if (object.reflectionTint != glm::dvec3(1.0))
        ensure(fields.reflectionTint, fields.lattice, glm::vec3(1.0f));
    if (rough)
        ensure(fields.roughness, fields.lattice, 0.0f);
    for (std::size_t voxel = 0; voxel < layer.extent.boundary.values.size(); ++voxel) {
        if (layer.extent.boundary.values[voxel] == 0)
            continue;
        if (!fields.reflectionTint.empty())
            fields.reflectionTint.values[voxel] = glm::vec3(object.reflectionTint);
        if (!fields.roughness.empty())
            fields.roughness.values[voxel] = rough ? float(object.roughness) : 0.0f;
    }
}

void composeDispersion(const ObjectLayer& layer, Fields& fields) {
    const double cauchyB = layer.object->cauchyB;
    if (!layer.changesIndex || (fields.cauchyB.empty() && cauchyB == 0.0))
        return;
    ensure(fields.cauchyB, fields.lattice, 0.0f);
    const bool byIndex = cauchyB != 0.0 && tellsMatterByIndex(layer);
    const DenseGrid<float> matter = byIndex ? matterByIndex(layer, fields.lattice) : DenseGrid<float>();
    for (std::size_t voxel = 0; voxel < fields.cauchyB.values.size(); ++voxel) {
        const double covered = layer.extent.indexAt(voxel);
        if (!(covered > kNoCoverage))
            continue;
        const double ofObject = matter.empty() ? cauchyB : cauchyB * double(matter.values[voxel]);
        float& before = fields.cauchyB.values[voxel];
        before = float(mixed(double(before), ofObject, covered));
    }
}

void composeMedia(const ObjectLayer& layer, Fields& fields) {
    if (layer.object->opaque)
        return;
    composeBands(layer, fields.lattice, notNegative("absorption", layer.object->absorption), fields.sigmaA);
    composeScattering(layer, fields);
    composeBands(layer, fields.lattice, notNegative("emission", layer.object->emission), fields.emission);
}

void composeOpaque(const ObjectLayer& layer, Fields& fields) {
    const Object& object = *layer.object;
    const DenseGrid<glm::vec3>* grid = layer.grid("opaque");
    if (fields.opaque.empty() && !object.opaque && !grid)
        return;
    ensure(fields.opaque, fields.lattice, gpu::kLeastDepth);
    ensure(fields.albedo, fields.lattice, glm::vec3(0.0f));
    composeAlbedo(layer, fields);
    const DenseGrid<float> extent = depthOf(layer.extent);
    if (grid) {
        const DenseGrid<float> matter = depthFromShares(sharesOf(firstComponent(*grid)));
        fields.opaque = joined(without(fields.opaque, without(extent, matter)), overlap(extent, matter));
    } else {
        fields.opaque = object.opaque ? joined(fields.opaque, extent) : without(fields.opaque, extent);
    }
}

void finishFields(Fields& fields) {
    const auto& mask = fields.interface.values;
    if (std::none_of(mask.begin(), mask.end(), [](unsigned char marked) { return marked != 0; }))
        fields.interface = {};
    if (allZero(fields.sigmaA))
        fields.sigmaA = {};
    if (allZero(fields.emission))
        fields.emission = {};
    if (allZero(fields.sigmaS)) {
        fields.sigmaS = {};
        fields.anisotropy = {};
        fields.anisotropyByBand = {};
    }
    if (allZero(fields.roughness))
        fields.roughness = {};
    const auto& tints = fields.reflectionTint.values;
    if (std::all_of(tints.begin(), tints.end(), [](const glm::vec3& tint) { return tint == glm::vec3(1.0f); }))
        fields.reflectionTint = {};
    const auto& opaque = fields.opaque.values;
    if (std::all_of(opaque.begin(), opaque.end(), [](float depth) { return depth <= 0.0f; })) {
        fields.opaque = {};
        fields.albedo = {};
    }
    if (!fields.sigmaS.empty())
        finishAnisotropy(fields);
    if (!fields.opaque.empty())
        spreadByOneVoxel(fields.albedo, [&](std::size_t v) { return fields.opaque.values[v] > 0.0f; });
    finishIndex(fields);
}

} // namespace eikonal
