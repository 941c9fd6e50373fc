#include "common/inset_bricks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <tbb/parallel_for.h>

namespace eikonal {
namespace {

glm::ivec3 brickCount(const Lattice& domain) { return (domain.size + kBrickVoxels - 1) / kBrickVoxels; }

/// An inset as the domain's bricks meet it.
class PlacedInset {
public:
    PlacedInset(const Inset& inset, const Lattice& domain)
        : pyramid_(inset.grids->pyramid), domain_(domain) {
        const Lattice& lattice = inset.grids->lattice;
        glm::dmat4 brickFromLocal(1.0 / (kBrickVoxels * lattice.voxel));
        brickFromLocal[3] = glm::dvec4(-lattice.min / (kBrickVoxels * lattice.voxel), 1.0);
        brickFromWorld_ = brickFromLocal * glm::inverse(inset.worldFromLocal);
    }

    /// Visits the inset's bricks that may have a point in common with a brick of the domain, widened by so many of the domain's
    /// voxels.
    template <class Visit>
    void forBricksIn(const glm::ivec3& domainBrick, double widening, const Visit& visit) const {
        const glm::dvec3 low = domain_.min + domain_.voxel * (double(kBrickVoxels) * glm::dvec3(domainBrick) - widening);
        const double edge = domain_.voxel * (kBrickVoxels + 2.0 * widening);
        const glm::dvec3 first(brickFromWorld_ * glm::dvec4(low, 1.0));
        glm::dvec3 from = first, to = first;
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dvec3 along = edge * glm::dvec3(brickFromWorld_[axis]);
            from += glm::min(along, glm::dvec3(0.0));
            to += glm::max(along, glm::dvec3(0.0));
        }
        const glm::ivec3 last = pyramid_.bricks.size - 1;
        if (glm::any(glm::lessThan(to, glm::dvec3(0.0))) || glm::any(glm::greaterThan(from, glm::dvec3(last + 1)))) return;
        const glm::ivec3 begin = glm::clamp(glm::ivec3(glm::floor(from)), glm::ivec3(0), last);
        const glm::ivec3 end = glm::clamp(glm::ivec3(glm::floor(to)), glm::ivec3(0), last);
        for (int k = begin.z; k <= end.z; ++k)
            for (int j = begin.y; j <= end.y; ++j)
                for (int i = begin.x; i <= end.x; ++i) visit(pyramid_.bricks.at(i, j, k));
    }

private:
    const FieldPyramid& pyramid_;
    const Lattice& domain_;
    glm::dmat4 brickFromWorld_{1.0};
};

bool holdsSomething(const FieldBrick& brick) {
    return brick.iorMax > 0.0f || brick.boundary || brick.matter || brick.opaque;
}

/// Of an inset's index times coverage: differences of neighbours half a unit in the last place off, each to its side, in its own
/// unit of length (as in negligibleGradient).
float roundingGradient(const InsetGrids& grids) {
    return float(std::sqrt(3.0) * double(grids.iorMax) * double(std::numeric_limits<float>::epsilon()) / grids.lattice.voxel);
}

/// What `own` of an inset adds to a brick of the domain.
void addBrick(const FieldBrick& own, const Inset& inset, FieldBrick& brick) {
    if (!holdsSomething(own)) return;
    const InsetGrids& grids = *inset.grids;
    const float perSceneUnit = float(1.0 / inset.scale);
    const float gradient = own.gradientMax > roundingGradient(grids) ? own.gradientMax * perSceneUnit : 0.0f;
    brick.gradientMax = std::max(brick.gradientMax, gradient);
    brick.dispersionMax = std::max(brick.dispersionMax, own.dispersionMax);
    brick.dispersedGradientMax = std::max(brick.dispersedGradientMax, own.dispersedGradientMax * perSceneUnit);
    if (own.iorMax > 0.0f) {
        brick.iorMin = std::min(brick.iorMin, grids.iorMin);
        brick.iorMax = std::max(brick.iorMax, grids.iorMax);
    }
    brick.boundary = brick.boundary || own.boundary;
    brick.matter = brick.matter || own.matter;
    brick.scatters = brick.scatters || own.scatters;
    brick.evenMatter = brick.evenMatter && own.evenMatter;
    brick.opaque = brick.opaque || own.opaque;
}

template <class Visit>
void forEachBrick(const glm::ivec3& count, const Visit& visit) {
    tbb::parallel_for(0, count.z, [&](int k) {
        for (int j = 0; j < count.y; ++j)
            for (int i = 0; i < count.x; ++i) visit(glm::ivec3(i, j, k));
    });
}

} // namespace

DenseGrid<InsetBrick> insetBricksOf(const Fields& fields) {
    constexpr double kWidening = 1.0;  // a step from outside the brick is as long
    DenseGrid<InsetBrick> bricks(brickCount(fields.lattice), {});
    for (std::size_t n = 0; n < fields.insets.size(); ++n) {
        const Inset& inset = fields.insets[n];
        const PlacedInset place(inset, fields.lattice);
        const float voxel = float(voxelOf(inset) / fields.lattice.voxel);
        forEachBrick(bricks.size, [&](const glm::ivec3& at) {
            bool any = false;
            place.forBricksIn(at, kWidening, [&](const FieldBrick& own) { any = any || holdsSomething(own); });
            if (!any) return;
            bricks.at(at).about |= 1u << n;
            bricks.at(at).finestVoxel = std::min(bricks.at(at).finestVoxel, voxel);
        });
    }
    return bricks;
}

InsetBounds boundsOf(const DenseGrid<InsetBrick>& bricks) {
    InsetBounds bounds;
    for (const InsetBrick& brick : bricks.values) {
        bounds.finestVoxel = std::min(bounds.finestVoxel, double(brick.finestVoxel));
        bounds.mostAbout = std::max(bounds.mostAbout, std::popcount(brick.about));
    }
    return bounds;
}

void addInsets(const Fields& fields, FieldPyramid& pyramid) {
    for (const Inset& inset : fields.insets) {
        const PlacedInset place(inset, fields.lattice);
        forEachBrick(pyramid.bricks.size, [&](const glm::ivec3& at) {
            place.forBricksIn(at, 0.0, [&](const FieldBrick& own) { addBrick(own, inset, pyramid.bricks.at(at)); });
        });
    }
}

} // namespace eikonal
