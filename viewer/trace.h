#pragma once
// Rays through a scene's index field, by the kernel that marches the viewing rays.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "common/effects.h"
#include "common/gpu/context.h"

namespace eikonal {

struct TraceRay {
    glm::dvec3 origin{0.0};     ///< [scene units]
    glm::dvec3 direction{0.0};  ///< any length but 0
    std::optional<double> wavelengthMicrons{};  ///< in vacuum; unset: that at which a scene gives its index
};

enum class TraceStatus { kExited, kAbsorbed, kLimit, kMissed };
/// `exited`, `absorbed` (hit something opaque), `limit` (of steps) or `missed` (never entered the domain).
std::string_view traceStatusName(TraceStatus status);

/// A ray at its end, or after a step. A ray that missed repeats its input, with zeros.
struct TraceResult {
    glm::dvec3 position{0.0};
    glm::dvec3 direction{0.0};   ///< unit
    double opticalLength = 0.0;  ///< integral of n ds inside the domain [scene units]
    double length = 0.0;         ///< [scene units]
    glm::dvec3 depth{0.0};       ///< integral of sigma_a ds by band
    std::uint32_t evaluations = 0;  ///< of the index field
    TraceStatus status = TraceStatus::kMissed;
};

struct TracePoint {
    std::size_t ray = 0;  ///< row of the input
    TraceResult at;       ///< with the status that the ray ends with
};

/// Whether rays cross places where nothing bends them in one flight, or step through everything.
enum class StraightFlights { kTaken, kNone };

/// Follows rays from where they enter the domain, or start inside, to where they leave; one result a ray, in order.
/// Of `effects`, refraction, dispersion, absorption and opaque count. Throws badInput for a step that is not positive, and for
/// a wavelength at which the index is not.
std::vector<TraceResult> traceRays(const gpu::Context& context, const Fields& fields, const EffectSet& effects,
                                   const Accuracy& accuracy, const std::vector<TraceRay>& rays,
                                   StraightFlights flights = StraightFlights::kTaken);

/// The same with every step, a flight being one: the entry, then each step's end; ray after ray.
std::vector<TracePoint> tracePaths(const gpu::Context& context, const Fields& fields, const EffectSet& effects,
                                   const Accuracy& accuracy, const std::vector<TraceRay>& rays);

/// What a boundary reflects of a ray, at its end; lengths, depth and evaluations count from the mirror on.
struct TraceReflection {
    std::size_t ray = 0;      ///< row of the input
    int generation = 0;       ///< mirrors on its way from the ray's start
    double throughput = 0.0;  ///< of what lies behind, polarisations averaged
    TraceResult at;
};

/// Reflections of rays and of their reflections, `accuracy.reflections` mirrors far; ray after ray, of each the last first.
/// What an image would leave to the environment because it is weak is missing. As traceRays otherwise; of `effects`,
/// reflection counts too.
std::vector<TraceReflection> traceReflections(const gpu::Context& context, const Fields& fields, const EffectSet& effects,
                                              const Accuracy& accuracy, const std::vector<TraceRay>& rays);

} // namespace eikonal
