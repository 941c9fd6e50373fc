#include "viewer/march.h"

#include <algorithm>
#include <cmath>

#include "common/error.h"

namespace eikonal::viewer {

namespace {

// Mesa's software renderer ends loops silently after 65535 iterations of an invocation, nested loops included; a vector of
// eight rays has one count, and in the worst case they take their turns one after the other.
constexpr std::uint32_t kIterationsPerDispatch = 65535 / 8;
constexpr std::uint32_t kIterationsPerFlight = 16;  // kSamplesPerFlight of shaders/viewer/flight.glsl
constexpr std::uint32_t kMirrorCorrections = 2;     // of shaders/physics/mirror.glsl
constexpr std::uint32_t kFaceTrials = 3;            // of shaders/viewer/face_step.glsl
constexpr std::uint32_t kLeastEvaluations = 4096;
constexpr double kDiagonals = 8.0;
// Between looks at whether a ray is under way still, for which the device is waited for. Most rays pass a ball in six.
constexpr std::uint32_t kSlicesAtATime = 8;

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
    const double diagonalSteps = glm::length(glm::dvec3(lattice.size)) / settings.stepVoxels;
    const double evaluations = kDiagonals * diagonalSteps * evaluationsPerStep(settings.integrator);
    return std::max(kLeastEvaluations, std::uint32_t(std::min(evaluations, 1e9)));
}

/// Loop iterations of a step or flight: its own, those to a mirror, and of each sample of matter one and those over the
/// voxels about it.
std::uint32_t iterationsPerStep(const std::vector<std::string>& defines, std::uint32_t samplesPerHalf) {
    constexpr std::uint32_t kVoxelsAbout = 8;
    const auto has = [&](const char* define) {
        return std::find(defines.begin(), defines.end(), define) != defines.end();
    };
    const std::uint32_t samples = std::max(has("STRAIGHT_FLIGHTS") ? kIterationsPerFlight : 1u, 2 * samplesPerHalf);
    const std::uint32_t toMirror = has("FOLLOW_REFLECTIONS") ? kMirrorCorrections : 0;
    return 1 + kFaceTrials + toMirror + samples * (has("LIGHT_LOBES") ? 1 + kVoxelsAbout : 1);
}

std::vector<std::string> withSteps(std::vector<std::string> defines, const MarchSettings& settings) {
    defines.push_back("SAMPLES_PER_HALF " + std::to_string(samplesPerHalfOf(settings)));
    if (settings.matterVoxels != 1.0) defines.push_back("MATTER_VOXELS " + std::to_string(settings.matterVoxels));
    if (const char* define = defineOf(settings.integrator)) defines.push_back(define);
    return defines;
}

} // namespace

March::March(const gpu::Context& context, const std::vector<std::string>& defines, const MarchSettings& settings,
             const Lattice& lattice)
    : samplesPerHalf_(samplesPerHalfOf(settings)),
      maxEvaluations_(evaluationLimit(settings, lattice)),
      stepsPerSlice_(settings.stepsPerSlice > 0 ? settings.stepsPerSlice
                                                : kIterationsPerDispatch / iterationsPerStep(defines, samplesPerHalf_)),
      stepLength_(settings.stepVoxels * lattice.voxel),
      plain_(context, "viewer/march.comp.glsl", withSteps(defines, settings)),
      eventful_(context, "viewer/event.comp.glsl", withSteps(defines, settings)) {}

void March::configure(gpu::ViewBlock& view) const {
    view.stepLength = float(stepLength_);
    view.maxEvaluations = maxEvaluations_;
    view.stepsPerSlice = stepsPerSlice_;
}

void March::run(RayBatch& batch) const {
    for (std::uint32_t slice = 0; slice < mostSlices(); ++slice) {
        runSlice(batch, slice);
        if ((slice + 1) % kSlicesAtATime == 0 && batch.listedCount(gpu::kPlainRays) == 0) return;
    }
}

void March::runSlice(RayBatch& batch, std::uint32_t slice) const {
    const gpu::uint taken = slice % 2 == 0 ? gpu::kPlainRays : gpu::kEventfulRays;
    const gpu::uint filled = slice % 2 == 0 ? gpu::kEventfulRays : gpu::kPlainRays;
    batch.clearList(filled);
    (slice % 2 == 0 ? plain_ : eventful_).dispatchIndirect(batch.lists, taken * sizeof(gpu::RayListHead));
}

} // namespace eikonal::viewer
