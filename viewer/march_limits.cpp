#include "viewer/march_limits.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "common/error.h"

namespace eikonal::viewer {

namespace {

constexpr std::uint32_t kMirrorCorrections = 2;     // of shaders/physics/mirror.glsl
constexpr std::uint32_t kFaceTrials = 3;            // of shaders/viewer/face_step.glsl
constexpr std::uint32_t kLeastEvaluations = 4096;
constexpr double kDiagonals = 8.0;

double checkedStep(double stepVoxels) {
    if (!(stepVoxels > 0.0) || !std::isfinite(stepVoxels)) {
        throw badInput("accuracy.step: expected a positive number of voxels, found " + std::to_string(stepVoxels));
    }
    return stepVoxels;
}

std::uint32_t samplesPerHalfOf(const MarchSettings& settings) {
    const double pieces = checkedStep(settings.stepVoxels) / settings.matterVoxels;
    return pieces <= 1.0 ? 0u : std::uint32_t(std::ceil(std::min(0.5 * pieces, 256.0)));
}

/// kEvaluationsPerStep of shaders/viewer/integrator.glsl.
double evaluationsPerStep(Integrator integrator) {
    return integrator == Integrator::kRk4 ? 4.0 : integrator == Integrator::kSharma ? 3.0 : 1.0;
}

/// What leapfrog needs no word for.
const char* defineOf(Integrator integrator) {
    switch (integrator) {
        case Integrator::kEuler: return "INTEGRATOR_EULER";
        case Integrator::kRk4: return "INTEGRATOR_RK4";
        case Integrator::kSharma: return "INTEGRATOR_SHARMA";
        default: return nullptr;
    }
}

std::uint32_t evaluationLimit(const MarchSettings& settings, const Lattice& lattice) {
    if (settings.maxEvaluations > 0) return settings.maxEvaluations;
    const double diagonalSteps = glm::length(glm::dvec3(lattice.size)) / (settings.stepVoxels * settings.insets.finestVoxel);
    const double evaluations = kDiagonals * diagonalSteps * evaluationsPerStep(settings.integrator);
    return std::max(kLeastEvaluations, std::uint32_t(std::min(evaluations, 1e9)));
}

bool isAmong(const std::vector<std::string>& defines, std::string_view define) {
    return std::find(defines.begin(), defines.end(), define) != defines.end();
}

/// How often a step or flight looks at the fields, each quantity by itself: in its evaluations and those to a mirror, for the band
/// of a boundary, twice for opaque matter, and for each kind of matter at each sample.
std::uint32_t lookUpsPerStep(const std::vector<std::string>& defines, Integrator integrator, std::uint32_t toMirror,
                             std::uint32_t samples) {
    const std::uint32_t tries = integrator == Integrator::kLeapfrog ? 1 : 1 + kFaceTrials;
    std::uint32_t lookUps = std::uint32_t(evaluationsPerStep(integrator)) * tries + toMirror + 1;
    lookUps += isAmong(defines, "EFFECT_OPAQUE") ? 2 : 0;
    for (const char* matter : {"EFFECT_ABSORPTION", "EFFECT_SCATTERING", "EFFECT_EMISSION"}) {
        lookUps += isAmong(defines, matter) ? samples : 0;
    }
    return lookUps;
}

/// Loop iterations of a step or flight: those of the loops about it, those at a face and to a mirror, of each sample of
/// matter one and those over the voxels about it, and of each look-up those over insets.
std::uint32_t iterationsPerStep(const std::vector<std::string>& defines, const MarchSettings& settings) {
    constexpr std::uint32_t kVoxelsAbout = 8;
    constexpr std::uint32_t kLoopsAbout = 4;  // over events, flights and steps in turn, flights, steps
    const std::uint32_t samples = std::max(1u, 2 * samplesPerHalfOf(settings));
    const std::uint32_t toMirror = isAmong(defines, "FOLLOW_REFLECTIONS") ? kMirrorCorrections : 0;
    const std::uint32_t overInsets = std::uint32_t(settings.insets.mostAbout) *
                                     lookUpsPerStep(defines, settings.integrator, toMirror, samples);
    return kLoopsAbout + kFaceTrials + toMirror + samples * (isAmong(defines, "LIGHT_LOBES") ? 1 + kVoxelsAbout : 1) + overInsets;
}

} // namespace

MarchLimits::MarchLimits(const gpu::Context& context, std::vector<std::string> defines, const MarchSettings& settings,
                         const Lattice& lattice)
    : defines_(std::move(defines)), settings_(settings), lattice_(lattice), portions_(portionsFor(context.limits())) {
    checkedStep(settings.stepVoxels);
    setInsets(settings.insets);
}

void MarchLimits::setInsets(const InsetBounds& insets) {
    settings_.insets = insets;
    maxEvaluations_ = evaluationLimit(settings_, lattice_);
    const std::uint32_t finished = portions_.loopsOfSlice / iterationsPerStep(defines_, settings_);
    stepsPerSlice_ = settings_.stepsPerSlice > 0 ? settings_.stepsPerSlice : std::clamp(finished, 1u, portions_.stepsOfSlice);
}

void MarchLimits::configure(gpu::ViewBlock& view) const {
    view.stepLength = float(settings_.stepVoxels * lattice_.voxel);
    view.maxEvaluations = maxEvaluations_;
    view.stepsPerSlice = stepsPerSlice_;
    view.fewRays = portions_.fewRays;
    view.stepsPerDispatch = portions_.stepsOfDispatch;
}

std::vector<std::string> stepDefines(const MarchSettings& settings) {
    std::vector<std::string> defines = {"SAMPLES_PER_HALF " + std::to_string(samplesPerHalfOf(settings))};
    if (const char* define = defineOf(settings.integrator)) defines.push_back(define);
    return defines;
}

bool stepsFreely(const std::vector<std::string>& defines, Integrator integrator) {
    if (!isAmong(defines, "EFFECT_REFRACTION") || integrator != Integrator::kLeapfrog) return false;
    const auto isAny = [&](std::initializer_list<const char*> others) {
        return std::any_of(others.begin(), others.end(), [&](const char* other) { return isAmong(defines, other); });
    };
    return !isAny({"EFFECT_ABSORPTION", "EFFECT_SCATTERING", "EFFECT_EMISSION", "EFFECT_REFLECTION", "EFFECT_OPAQUE", "INSETS"});
}

} // namespace eikonal::viewer
