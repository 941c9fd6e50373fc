#include "lightsim/lobes.h"

#include <algorithm>
#include <span>

#include "common/depth.h"
#include "common/physics.h"

namespace eikonal::bake {

namespace {

// 1 - |F|/E, or Σ|F| lost, below which there is nothing but rounding: directions that differ by a quarter of a degree.
constexpr double kRounding = 1e-5;

// A voxel from a point source the linear change between neighbours tells less than half of what there is within the voxel.
constexpr double kTurningMargin = 3.0;
// Product of two neighbours' F/E below which they are opposed: more than chance makes of beams that cancel each other.
constexpr double kOpposed = -0.1;

/// How much shorter than 1 F/E may be because one sheet turns within the voxel: by the variance of a direction that changes
/// linearly, a twelfth of its change across the voxel squared, halved; with a margin. That is a matter of resolution, not of
/// crossing. Where neighbours' directions are opposed the voxel holds a source, and turning explains all.
double turningWithin(const BakedLight& light, const glm::ivec3& voxel) {
    double turning = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 step(0);
        step[axis] = 1;
        const glm::ivec3 before = glm::max(voxel - step, glm::ivec3(0));
        const glm::ivec3 after = glm::min(voxel + step, light.lattice.size - 1);
        if (overBands(light.irradiance.at(before)) > 0.0 && overBands(light.irradiance.at(after)) > 0.0) {
            const glm::dvec3 first(light.lightDirection.at(before)), second(light.lightDirection.at(after));
            if (glm::dot(first, second) < kOpposed) {
                return 1.0;
            }
            const double distance = std::max(after[axis] - before[axis], 1);
            turning += glm::dot(second - first, second - first) / (24.0 * distance * distance);
        }
    }
    return kTurningMargin * turning;
}

glm::ivec3 indexOf(std::size_t voxel, const glm::ivec3& size) {
    const std::size_t x = std::size_t(size.x), y = std::size_t(size.y);
    return {int(voxel % x), int(voxel / x % y), int(voxel / (x * y))};
}

/// What a voxel gets in all, in units of the deposit, over bands that are told apart.
std::vector<double> depositedUnits(std::span<const std::uint32_t> voxels, const BakedLight& light, const LobePlan& plan) {
    std::vector<double> units;
    for (const std::uint32_t voxel : voxels) {
        const double free = freeShareAt(plan.fields.opaque, voxel);
        units.push_back(overBands(light.irradiance.values[voxel]) * free / (plan.depositUnit * (plan.bands == 3 ? 1.0 : 3.0)));
    }
    return units;
}

/// What is scattered along a direction of travel, over the coefficient.
double phased(const std::vector<DirectedLight>& lobes, const glm::dvec3& travel, double g) {
    double sum = 0.0;
    for (const DirectedLight& lobe : lobes) {
        sum += lobe.power() * f64::phaseOfFlux(-travel, lobe.flux / lobe.power(), g);
    }
    return sum;
}

/// Adds a voxel's light by direction as lobes, where one does not do.
void addRow(LobeTable& table, std::uint32_t voxel, std::vector<DirectedLight> byDirection, const LobeCriterion& criterion,
            const BakedLight& light) {
    const std::vector<DirectedLight> lobes = mergedLobes(std::move(byDirection), criterion.mergeTolerance(voxel));
    if (criterion.isToBeKept(voxel, lobes)) {
        table.voxels.push_back(voxel);
        table.rows.push_back(lobesOfVoxel(lobes, light.irradiance.values[voxel], light.lightDirection.values[voxel]));
    }
}

/// The lobes of a voxel; its whole light where it has no row.
void appendLobes(const BakedLight& light, std::uint32_t voxel, std::vector<DirectedLight>& lobes) {
    const VoxelLobes* row = light.lobes.find(voxel);
    const VoxelLobes whole{LightLobe{light.irradiance.values[voxel], light.lightDirection.values[voxel]}};
    for (const LightLobe& lobe : row ? *row : whole) {
        if (overBands(lobe.irradiance) > 0.0) {
            lobes.push_back(directedLight(lobe));
        }
    }
}

} // namespace

LobeCriterion::LobeCriterion(const Accuracy& accuracy, const Fields& fields, const EffectSet& effects)
    : directional_(accuracy.directional), tolerance_(accuracy.tolerance), fields_(fields) {
    const bool hasUse =
        effects.has(Effect::kScattering) && !fields.anisotropy.empty() && !effects.has(Effect::kDispersion);
    if (directional_ == Directional::kAuto && (!hasUse || accuracy.deposit == eikonal::Deposit::kPeak)) {
        directional_ = Directional::kMean;
    }
}

double LobeCriterion::mergeTolerance(std::size_t voxel) const {
    if (directional_ == Directional::kLobes) {
        return kRounding;
    }
    const double error = f64::phaseErrorPerSpread(fields_.anisotropy.values[voxel]);
    return error > 0.0 ? std::max(tolerance_ / error, kRounding) : 1.0;
}

std::vector<std::uint32_t> LobeCriterion::voxelsOf(const BakedLight& light) const {
    std::vector<std::uint32_t> voxels;
    if (directional_ == Directional::kMean) {
        return voxels;
    }
    const bool everywhere = directional_ == Directional::kLobes;
    for (std::size_t voxel = 0; voxel < light.irradiance.values.size(); ++voxel) {
        const bool isLit = overBands(light.irradiance.values[voxel]) > 0.0;
        if (!isLit || (!everywhere && fields_.sigmaS.values[voxel] == glm::vec3(0.0f))) {
            continue;
        }
        const double spread = 1.0 - glm::length(glm::dvec3(light.lightDirection.values[voxel]));
        const double tolerance = mergeTolerance(voxel);
        if (spread > tolerance &&
            (everywhere || spread - turningWithin(light, indexOf(voxel, light.lattice.size)) > tolerance)) {
            voxels.push_back(std::uint32_t(voxel));
        }
    }
    return voxels;
}

bool LobeCriterion::isToBeKept(std::size_t voxel, const std::vector<DirectedLight>& lobes) const {
    if (lobes.size() < 2 || directional_ == Directional::kLobes) {
        return lobes.size() > 1;
    }
    const double g = fields_.anisotropy.values[voxel];
    const std::vector<DirectedLight> whole = mergedLobes(lobes, 1.0);
    const double most = whole.front().power() * f64::henyeyGreenstein(1.0, std::abs(g));
    const auto differs = [&](const DirectedLight& along) {
        const double length = glm::length(along.flux);
        const glm::dvec3 travel = length > 0.0 ? along.flux / length : glm::dvec3(1.0, 0.0, 0.0);
        return std::abs(phased(lobes, travel, g) - phased(whole, travel, g)) > tolerance_ * most;
    };
    return std::any_of(lobes.begin(), lobes.end(), differs) || differs(whole.front());
}

LobeTable lobesOf(const gpu::Context& context, LightMethod& method, const LobeCriterion& criterion, const LobePlan& plan,
                  const BakedLight& light, const std::function<void(double)>& progress) {
    const std::vector<std::uint32_t> voxels = criterion.voxelsOf(light);
    const std::vector<double> units = depositedUnits(voxels, light, plan);
    LobeTable table;
    for (const LobeTile& tile : lobeTiles(voxels, light.lattice, plan.blockBytes)) {
        const LobeBins bins(context, voxels, units, tile, light.lattice, plan.bands);
        method.propagateInto(bins, progress);
        auto byDirection = bins.read();
        for (std::size_t row = 0; row < tile.count; ++row) {
            const std::uint32_t voxel = voxels[tile.first + row];
            addRow(table, voxel, std::move(byDirection[row]), criterion, light);
        }
    }
    return table;
}

LobeTable summedLobes(const LobeCriterion& criterion, const std::vector<NamedLight>& parts, const BakedLight& sum) {
    LobeTable table;
    for (const std::uint32_t voxel : criterion.voxelsOf(sum)) {
        std::vector<DirectedLight> lobes;
        for (const NamedLight& part : parts) {
            appendLobes(part.light, voxel, lobes);
        }
        addRow(table, voxel, std::move(lobes), criterion, sum);
    }
    return table;
}

} // namespace eikonal::bake
