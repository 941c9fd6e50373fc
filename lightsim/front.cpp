#include "lightsim/front.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "common/accuracy.h"
#include "common/device_frame.h"
#include "common/gpu_fields.h"
#include "common/interrupt.h"
#include "common/physics.h"
#include "lightsim/emit.h"
#include "lightsim/power_unit.h"
#include "lightsim/settings.h"
#include "lightsim/wavefront.h"

namespace eikonal {

namespace bake {
namespace {
#include "shaders/lightsim/share.glsl"
} // namespace
} // namespace bake

namespace {

/// Reaches into the domain, and not all of its light has come to an end.
bool isInDomain(const bake::WavefrontPatch& patch, const Lattice& lattice) {
    glm::dvec3 low(1e300), high(-1e300);
    bool travels = false;
    for (const bake::Particle& corner : patch.corners) {
        low = glm::min(low, glm::dvec3(corner.x));
        high = glm::max(high, glm::dvec3(corner.x));
        travels = travels || corner.status <= PARTICLE_INSIDE;
    }
    return travels && glm::all(glm::lessThan(worldFromDevice(lattice, low), lattice.max())) &&
           glm::all(glm::greaterThan(worldFromDevice(lattice, high), lattice.min));
}

/// What is left of a patch's power: opaque matter keeps what it has stopped.
glm::vec3 shareOf(const bake::WavefrontPatch& patch) {
    glm::vec3 share(0.0f);
    for (const bake::Particle& corner : patch.corners) {
        share += corner.status == PARTICLE_BLOCKED ? glm::vec3(0.0f) : 0.25f * bake::remainingShare(corner);
    }
    return share;
}

/// Between the corners of a patch that has grown long and is too weak to be split there may be anything.
bool isSurface(const bake::WavefrontPatch& patch, const bake::LaunchFrame& frame, const bake::BakeSettings& settings) {
    const auto& corners = patch.corners;
    float longest = 0.0f;
    for (std::size_t i = 0; i < 4; ++i) {
        longest = std::max(longest, glm::distance(corners[i].x, corners[(i + 1) % 4].x));
    }
    const glm::vec3 power = patch.power * shareOf(patch);
    return longest <= settings.maxSide || std::max({power.r, power.g, power.b}) > frame.splitPower;
}

bool isFolded(const bake::WavefrontPatch& patch, const bake::LaunchFrame& frame) {
    const glm::vec3 travel = frame.isPoint != 0u ? frame.axis : frame.origin;
    const std::uint32_t launched = glm::dot(glm::cross(frame.a, frame.b), travel) > 0.0f ? 1u : 2u;
    return patch.orientation != 0u && patch.orientation != launched;
}

FrontPatch frontPatchOf(const bake::WavefrontPatch& patch, const bake::LaunchFrame& frame, const Lattice& lattice,
                        double opticalTime) {
    FrontPatch front;
    front.opticalTime = opticalTime;
    glm::vec3 travel(0.0f);
    for (std::size_t i = 0; i < front.corners.size(); ++i) {
        front.corners[i] = glm::vec3(worldFromDevice(lattice, glm::dvec3(patch.corners[i].x)));
        travel += patch.corners[i].w;
    }
    const auto& x = patch.corners;
    const float covered = f32::coveredSection(x[0].x, x[1].x, x[2].x, x[3].x, glm::normalize(travel));
    front.irradiance = patch.power * shareOf(patch) / std::max(covered, 1e-30f);
    front.folded = isFolded(patch, frame);
    front.launchFrame = patch.frameIndex;
    front.launchMin = patch.launchMin;
    front.launchMax = patch.launchMax;
    return front;
}

bool launchedBefore(const FrontPatch& a, const FrontPatch& b) {
    return std::tie(a.launchFrame, a.launchMin.y, a.launchMin.x) < std::tie(b.launchFrame, b.launchMin.y, b.launchMin.x);
}

/// Every patch ends at the step at which it has come to the time: patches of the same round differ in age, because those
/// that find no room in the pool wait.
std::vector<FrontPatch> frontAt(double opticalTime, bake::Wavefront& wavefront, const bake::LaunchGrids& grids,
                                const Lattice& lattice, bake::BakeSettings settings,
                                const std::function<void(double)>& progress) {
    std::vector<FrontPatch> front;
    const double steps = std::ceil(opticalTime / double(settings.opticalStep) * (1.0 - 1e-6));
    if (steps > settings.maxSteps) {
        return front;
    }
    settings.maxSteps = std::max(1u, std::uint32_t(steps));
    settings.opticalStep = float(opticalTime / settings.maxSteps);
    wavefront.restart(settings);
    for (bake::QueueState state{}; !isFinished(state, settings);) {
        wavefront.emit();
        wavefront.propagate();
        wavefront.refine();
        for (const bake::WavefrontPatch& patch : wavefront.retiredPatches()) {
            const bake::LaunchFrame& frame = grids.frames[patch.frameIndex];
            const bool arrived = patch.stepCount == settings.maxSteps && isInDomain(patch, lattice);
            if (arrived && isSurface(patch, frame, settings)) {
                front.push_back(frontPatchOf(patch, frame, lattice, opticalTime));
            }
        }
        state = wavefront.state();
        throwIfInterrupted();
        progress(double(state.nextCell) / double(settings.cellCount));
    }
    std::sort(front.begin(), front.end(), launchedBefore);
    return front;
}

} // namespace

std::vector<FrontPatch> frontsAt(const gpu::Context& context, const Scene& scene, const Fields& fields,
                                 const EffectSet& effects, const std::vector<double>& opticalTimes,
                                 const BakeOptions& options) {
    Accuracy accuracy = scene.accuracy;
    if (!bake::usesPatches(accuracy)) {
        accuracy.deposit = Deposit::kSplat;
    }
    const bake::Criteria criteria = bake::criteriaOf(accuracy, fields);
    const LightSet lights = lightsAt(lightsOf(scene, effects), 0.0);
    const double powerUnit = bake::powerUnitOf(lights);
    const bake::LaunchGrids grids =
        bake::launchGrids(bake::inPowerUnits(lights, glm::dvec3(powerUnit)), fields.lattice, criteria);
    if (!(grids.strongestPower > 0.0)) {
        return {};
    }
    const GpuFields gpuFields(context, fields, effects.without(Effect::kDispersion),
                              bake::interpolationOfLight(accuracy, fields.ior));
    gpuFields.bind();
    const bake::BakeSettings settings = bake::settingsOf(criteria, grids, fields, options);
    bake::Wavefront wavefront(context, gpuFields.defines(), grids, settings);
    std::vector<FrontPatch> fronts;
    for (std::size_t i = 0; i < opticalTimes.size(); ++i) {
        const auto progress = [&](double fraction) {
            if (options.progress) {
                options.progress((double(i) + fraction) / double(opticalTimes.size()));
            }
        };
        const auto front = frontAt(opticalTimes[i], wavefront, grids, fields.lattice, settings, progress);
        fronts.insert(fronts.end(), front.begin(), front.end());
    }
    context.throwIfError();
    for (FrontPatch& patch : fronts) {
        patch.irradiance *= float(powerUnit);
    }
    return fronts;
}

} // namespace eikonal
