#include "lightsim/settings.h"

#include <algorithm>
#include <cmath>

#include "common/accuracy.h"
#include "common/cubic_spline.h"
#include "common/spectral_fields.h"

namespace eikonal::bake {

namespace {

constexpr double kDefaultTolerance = 0.02;
// Above it steps of ray tubes and their launch grids about a light nearby grow too, with its root: up to there rays err by
// less than what lies between them.
constexpr double kDraftTolerance = 0.1;
constexpr double kLongestStepVoxels = 2.0;  // of tubes: boundaries are some six voxels wide
// Light that is still in the domain after this many optical diagonals at the default tolerance is caught in total
// reflection: culled. In a smoothed sphere about a thousandth of a beam is, whatever the limit.
constexpr double kMaxDiagonals = 2.5;
// Kernels trace a whole path in one dispatch, to its mirrors and from the source again; software renderers end loops at 65535
// iterations in all.
constexpr double kMaxSteps = 32000.0;
// Of the launch grids that ray tubes start from, with rays half as far apart.
constexpr double kTubeCellVoxels = 8.0;
// Tubes interpolate between rays where patches that are not split deposit along them: they can stop at that many times the
// power.
constexpr double kTubeSplitVoxels = 10.0;
// What tubes go by must fall faster than their error: on the glass sphere at 64³ that is 1.8 % where they go by 0.02 and
// 1.45 % by 0.005.
constexpr double kLeastTubeShare = 0.5;
constexpr std::uint32_t kRecordCapacity = 1u << 20;

/// What the refinement of tubes goes by, so that their error is about the tolerance.
double tubeTolerance(const Accuracy& accuracy) {
    return accuracy.tolerance * std::clamp(accuracy.tolerance / kDefaultTolerance, kLeastTubeShare, 1.0);
}

struct IorRange {
    double low, high;
};

IorRange iorRangeOf(const Fields& fields) {
    if (fields.ior.empty()) {
        return {fields.iorUniform, fields.iorUniform};
    }
    const auto [low, high] = std::minmax_element(fields.ior.values.begin(), fields.ior.values.end());
    return {*low, *high};
}

bool isGrey(const glm::dvec3& strength) { return strength.x == strength.y && strength.y == strength.z; }

bool isGrey(const DirectionalLight& light) { return isGrey(light.irradiance); }

template <class Powered>
bool isGrey(const Powered& light) {
    return isGrey(light.power);
}

} // namespace

bool usesPatches(const Accuracy& accuracy) {
    return accuracy.deposit == eikonal::Deposit::kSplat || accuracy.deposit == eikonal::Deposit::kPeak;
}

Interpolation interpolationOfLight(const Accuracy& accuracy, const DenseGrid<float>& ior) {
    const Interpolation ofRays = interpolationOfImages(accuracy);
    if (accuracy.interpolation != Interpolation::kAuto || usesPatches(accuracy)) return ofRays;
    // Tubes through splines err twice as much as linearly where n is kinked, about half as much where the program has smoothed
    // it: midway between the two.
    constexpr double kMostKinks = 0.55;
    return !ior.empty() && kinkShare(ior) < kMostKinks ? Interpolation::kCubic : Interpolation::kLinear;
}

Criteria criteriaOf(const Accuracy& accuracy, const Fields& fields, double meshScale) {
    const double voxel = fields.lattice.voxel;
    const double refinement = std::clamp(std::sqrt(accuracy.tolerance / kDefaultTolerance), 0.25, 2.0);
    const glm::ivec3 size = fields.lattice.size;
    const double longest = std::max({size.x, size.y, size.z});
    Criteria criteria{};
    criteria.foldsEnd = accuracy.deposit == eikonal::Deposit::kPeak;
    // A step is at most one voxel of length where n is least, but for drafts; more of them gain nothing over the floor
    // that interpolation and what lies between rays set (docs/accuracy.md). The largest irradiance is looked for twice as often.
    const double draft = usesPatches(accuracy) ? 1.0 : std::max(1.0, std::sqrt(accuracy.tolerance / kDraftTolerance));
    const double autoStepVoxels = criteria.foldsEnd ? 0.5 : std::min(draft, kLongestStepVoxels);
    criteria.opticalStep =
        meshScale * accuracy.stepVoxels.value_or(autoStepVoxels) * voxel * std::min(1.0, iorRangeOf(fields).low);
    criteria.maxSide = meshScale * (usesPatches(accuracy) ? refinement : kTubeCellVoxels) * voxel;
    criteria.coarseness = meshScale * draft;
    // The light's mean power per voxel of a cross-section, times the share of it that may be misplaced by not splitting.
    criteria.splitShare = (usesPatches(accuracy) ? accuracy.tolerance : kTubeSplitVoxels * tubeTolerance(accuracy)) /
                          (longest * longest);
    criteria.cullShare = 1e-3 * accuracy.tolerance;
    // every reflection followed takes light through the domain once more
    criteria.maxOpticalPath = (kMaxDiagonals + accuracy.reflections) / refinement * glm::length(fields.lattice.extent()) *
                              std::max(1.0, iorRangeOf(fields).high);
    return criteria;
}

BakeSettings settingsOf(const Criteria& criteria, const LaunchGrids& grids, const Fields& fields,
                        const BakeOptions& options) {
    BakeSettings settings{};
    settings.opticalStep = float(criteria.opticalStep);
    settings.maxSide = float(criteria.maxSide);
    settings.cullShare = float(criteria.cullShare);
    settings.maxSteps = std::uint32_t(std::min(kMaxSteps, std::ceil(criteria.maxOpticalPath / criteria.opticalStep)));
    // What a voxel's area of a launch grid carries over four voxels of path fits one signed word, three bands together; all
    // the power along the longest path into a single voxel stays below 2^60 units.
    const double power = std::max(grids.strongestPower, 1e-300);
    const double longestPathVoxels = settings.maxSteps * criteria.opticalStep / fields.lattice.voxel /
                                     std::min(1.0, iorRangeOf(fields).low);
    const double voxelsPerCell = std::pow(std::max(1.0, criteria.maxSide / fields.lattice.voxel), 2.0);
    settings.depositScale = float(std::min(std::exp2(30.0) * voxelsPerCell / (3.0 * 4.0 * grids.strongestCellPower),
                                           std::exp2(60.0) / (power * longestPathVoxels)));
    // what a row holds is at most that power, a few times over where reflections are followed
    settings.ledgerScale = float(std::exp2(60.0) / power);
    settings.cellCount = grids.cellCount;
    settings.capacity = std::max(8u, options.poolPatches);
    settings.recordCapacity = kRecordCapacity;
    settings.foldsEnd = criteria.foldsEnd ? 1u : 0u;
    return settings;
}

TubeSettings tubeSettingsOf(const Accuracy& accuracy, const Fields& fields) {
    const double voxel = fields.lattice.voxel;
    const double refinement = std::sqrt(tubeTolerance(accuracy) / kDefaultTolerance);
    TubeSettings settings{};
    // On the glass sphere at 64³, 0.1 instead of 0.2 takes 38 % more rays for 3 % less error.
    settings.maxDeviation = float(0.15 * refinement * voxel);
    settings.maxShareDeviation = float(0.01 * refinement);
    // Closer together than that, what is on either side of a shadow's edge makes no difference to a voxel.
    settings.resolvedSide = float(0.5 * voxel);
    // There, what is misplaced about the focus is 0.66 % of the light at 0.6, 0.47 % at 0.3 and 0.33 % at 0.2. Samples err by a
    // square of it, lines by chance: when it fell with the tolerance a lamp was in lines to 16 voxels from it, 3 % off at 0.001.
    settings.maxUnevenness = float(0.2 * std::max(refinement, 1.0));
    // Most of what a voxel's mean errs by: 3 along each axis at the default, 4 at half of what tubes go by, 2 above. With 2 the
    // default takes an eighth of the time less and errs by a fifth more on the glass sphere, more on smooth fronts; with 3 drafts
    // take a third of the time more, with 1 a seventh less and err twice as much.
    settings.samplesPerVoxel = std::uint32_t(std::clamp(std::lround(2.6 / std::pow(refinement, 2.0 / 3.0)), 2l, 4l));
    // Parabolas through three rays misjudge a cubic map by 4/3 of it along each of two directions.
    settings.maxUnevenSpread = float(0.375 * tubeTolerance(accuracy));
    settings.evenSide = float(1.5 * voxel);
    settings.nearMargin = float(kTubeCellVoxels * voxel);
    return settings;
}

bool isGreyMatter(const Fields& fields, const EffectSet& effects, const Accuracy& accuracy) {
    const bool tints = effects.has(Effect::kTint) && accuracy.reflections > 0;
    return (!effects.has(Effect::kAbsorption) || isGrey(fields.sigmaA)) &&
           (!effects.has(Effect::kScattering) || isGrey(fields.sigmaS)) && (!tints || isGrey(fields.reflectionTint));
}

bool isGreyLight(const LightSet& lights) {
    return std::all_of(lights.lights.begin(), lights.lights.end(),
                       [](const Light& light) { return std::visit([](const auto& one) { return isGrey(one); }, light); }) &&
           std::all_of(lights.environment.begin(), lights.environment.end(),
                       [](const DirectionalLight& beam) { return isGrey(beam); });
}

} // namespace eikonal::bake
